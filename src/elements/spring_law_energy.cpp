#include "elements/spring_law_energy.hpp"

#include <cmath>

#include "numerics/kronrod_rule.hpp"

namespace gxrod {
namespace {

constexpr std::size_t gauss_points = 7;
// Halvings, which close in on a kink or a jump.
constexpr int most_halvings = 50;

struct Integral {
    double value = 0.0;
    double error = 0.0;
    double size = 0.0;  // of the integrand's magnitude
};

Integral apply_rule(const SpringLaw& law, double from, double to) {
    const double centre = 0.5 * (from + to);
    const double half = 0.5 * (to - from);
    double kronrod = 0.0;
    double gauss = 0.0;
    double size = 0.0;
    const auto add = [&](double xi, const KronrodPoint& point) {
        const double force = law(centre + half * xi, 0.0);
        kronrod += point.weight * force;
        gauss += point.gauss_weight * force;
        size += point.weight * std::abs(force);
    };
    for (const KronrodPoint& point : find_kronrod_rule(gauss_points)) {
        add(point.xi, point);
        if (point.xi != 0.0) add(-point.xi, point);
    }
    return {half * kronrod, std::abs(half * (kronrod - gauss)), std::abs(half) * size};
}

double integrate(const SpringLaw& law, double from, double to, double allowed, int halvings) {
    const Integral whole = apply_rule(law, from, to);
    if (!(whole.error > allowed) || halvings == 0) return whole.value;
    const double middle = 0.5 * (from + to);
    return integrate(law, from, middle, allowed, halvings - 1) +
           integrate(law, middle, to, allowed, halvings - 1);
}

}  // namespace

double compute_law_energy(const SpringLaw& law, double length) {
    constexpr double share = 1e-13;
    const double allowed = share * apply_rule(law, law.start(), length).size;
    return integrate(law, law.start(), length, allowed, most_halvings);
}

}  // namespace gxrod
