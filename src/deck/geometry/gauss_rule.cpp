#include "deck/geometry/gauss_rule.hpp"

#include <cmath>

namespace gxrod {
namespace {

constexpr int points = 12;

struct Legendre {
    double value, slope;
};

// The Legendre polynomial of degree `points` by its three-term recurrence, |x| < 1.
Legendre compute_legendre(double x) {
    double previous = 1.0;
    double value = x;
    for (int n = 1; n < points; ++n) {
        const double next = ((2 * n + 1) * x * value - n * previous) / (n + 1);
        previous = value;
        value = next;
    }
    return {value, points * (previous - x * value) / (1.0 - x * x)};
}

std::array<GaussPoint, points> compute_rule() {
    std::array<GaussPoint, points> rule;
    for (int i = 0; i < points; ++i) {
        double x = -std::cos(M_PI * (i + 0.75) / (points + 0.5));
        for (int iteration = 0; iteration < 10; ++iteration) {
            const Legendre p = compute_legendre(x);
            x -= p.value / p.slope;
        }
        const double slope = compute_legendre(x).slope;
        rule[static_cast<std::size_t>(i)] = {0.5 * (1.0 + x), 1.0 / ((1.0 - x * x) * slope * slope)};
    }
    return rule;
}

}  // namespace

const std::array<GaussPoint, points>& gauss_rule() {
    static const std::array<GaussPoint, points> rule = compute_rule();
    return rule;
}

}  // namespace gxrod
