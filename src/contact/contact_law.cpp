#include "contact/contact_law.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>

namespace gxrod {
namespace {

// V/(κ ĝ) of e = 1 − x: −ln(1 − e) − e − e²/2, which is Σ e^k/k from k = 3 on.
double compute_relative_energy(double e) {
    if (e > 0.25) return -std::log1p(-e) - e * (1.0 + 0.5 * e);
    double sum = 0.0;
    for (int k = 26; k >= 3; --k) sum = sum * e + 1.0 / k;
    return sum * e * e * e;
}

}  // namespace

double compute_contact_force(const ContactLaw& law, double gap) {
    assert(gap > 0.0);
    const double x = gap / law.skin;
    return x < 1.0 ? law.stiffness * (1.0 - x) * (1.0 - x) / x : 0.0;
}

double compute_contact_force_slope(const ContactLaw& law, double gap) {
    assert(gap > 0.0);
    const double x = gap / law.skin;
    return x < 1.0 ? -law.stiffness / law.skin * (1.0 - x) * (1.0 + x) / (x * x) : 0.0;
}

double compute_contact_energy(const ContactLaw& law, double gap) {
    assert(gap > 0.0);
    const double x = gap / law.skin;
    if (x >= 1.0) return 0.0;
    // Of deep gaps by ln x: 1 − x has lost their digits.
    const double relative =
        x < 0.25 ? -std::log(x) - 1.5 + x * (2.0 - 0.5 * x) : compute_relative_energy(1.0 - x);
    return law.stiffness * law.skin * relative;
}

ContactGraphPoint find_contact_point(const ContactLaw& law, double zeta) {
    const double z = 1.0 + zeta;
    if (z <= 0.0) return {-zeta * law.skin, 0.0, 0.0};
    return {
        law.skin / (1.0 + z), law.stiffness * z * z / (1.0 + z), law.stiffness / law.skin * z * (2.0 + z)};
}

ContactGraphPoint continue_contact(const ContactLaw& law, double zeta, double gap) {
    ContactGraphPoint point = find_contact_point(law, zeta);
    point.force -= point.stiffness * (gap - point.gap);
    point.gap = gap;
    return point;
}

double advance_contact(const ContactLaw& law, double zeta, double gap, double change) {
    const double reached = gap + change;
    return std::max(continue_contact(law, zeta, reached).force / law.stiffness - reached / law.skin,
                    no_contact);
}

double find_predicted_share(double skin, double gap) {
    return gap < skin ? 0.9 : std::max(0.5 * skin / gap, 0.1);
}

double find_kept_share(double skin, double gap) {
    const auto force = [](double x) { return x < 1.0 ? (1.0 - x) * (1.0 - x) * (1.0 - x) / (x * x) : 0.0; };
    const double most = std::max(10.0 * force(gap / skin), 1e-3);
    double low = 0.1 * gap / skin, high = std::min(gap / skin, 1.0);
    if (!(low < high)) return 0.1;
    for (int halving = 0; halving < 12; ++halving) {
        const double middle = 0.5 * (low + high);
        (force(middle) > most ? low : high) = middle;
    }
    return high * skin / gap;
}

}  // namespace gxrod
