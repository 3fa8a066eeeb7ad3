#include "contact/contact_law.hpp"

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

// Relative energies from which the gap is sought by its logarithm; below, by the cube root of the energy.
constexpr double energy_of_deep_gaps = 0.1;

// In y = ln x the energy is convex and falls; x = exp(−v − 3/2) lies below the root, so the iterates ascend
// to it.
double find_deep_gap(double energy) {
    double y = -energy - 1.5;
    for (int iteration = 0; iteration < 50; ++iteration) {
        const double x = std::exp(y);
        const double e = -std::expm1(y);
        const double change = (-y - e * (1.0 + 0.5 * e) - energy) / (e * e);
        y += change;
        if (std::abs(change) < 1e-15 * (1.0 + std::abs(y)) || x == 0.0) break;
    }
    return std::exp(y);
}

// (3 v)^(1/3) is e (1 + e/4 + …), nearly straight.
double find_depth_of_shallow_gap(double energy) {
    const double wanted = std::cbrt(3.0 * energy);
    double e = wanted / (1.0 + 0.25 * wanted);
    for (int iteration = 0; iteration < 20; ++iteration) {
        const double root = std::cbrt(3.0 * compute_relative_energy(e));
        const double slope = e * e / ((1.0 - e) * root * root);
        const double change = (wanted - root) / slope;
        e += change;
        if (std::abs(change) < 1e-15 * e) break;
    }
    return e;
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

double find_gap_of_contact_energy(const ContactLaw& law, double energy) {
    assert(energy >= 0.0);
    const double relative = energy / (law.stiffness * law.skin);
    if (relative == 0.0) return law.skin;
    if (relative > energy_of_deep_gaps) return law.skin * find_deep_gap(relative);
    return law.skin * (1.0 - find_depth_of_shallow_gap(relative));
}

double find_contact_parameter(const ContactLaw& law, double gap) {
    assert(gap > 0.0);
    const double x = gap / law.skin;
    return x < 1.0 ? 1.0 / x - 2.0 : -x;
}

double find_parameter_of_force(const ContactLaw& law, double force) {
    assert(force >= 0.0);
    // With z = 1 + ζ: z² = y (1 + z).
    const double y = force / law.stiffness;
    return 0.5 * (y + std::sqrt(y * (y + 4.0))) - 1.0;
}

ContactGraphPoint find_contact_point(const ContactLaw& law, double zeta) {
    const double z = 1.0 + zeta;
    if (z <= 0.0) return {-zeta * law.skin, 0.0, 0.0};
    return {
        law.skin / (1.0 + z), law.stiffness * z * z / (1.0 + z), law.stiffness / law.skin * z * (2.0 + z)};
}

double compute_tangent_force(const ContactLaw& law, double zeta, double gap) {
    const ContactGraphPoint point = find_contact_point(law, zeta);
    return point.force - point.stiffness * (gap - point.gap);
}

double advance_contact_parameter(const ContactLaw& law, double zeta, double gap, double gap_change) {
    const double next = gap + gap_change;
    return compute_tangent_force(law, zeta, next) / law.stiffness - next / law.skin;
}

}  // namespace gxrod
