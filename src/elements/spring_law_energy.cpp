#include "elements/spring_law_energy.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

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

struct Point {
    double xi;
    double weight, gauss_weight;
    // Weights in the values at ξ = −1 and ξ = 1 of the polynomial through all points.
    std::array<double, 2> to_ends{1.0, 1.0};
};

constexpr std::array<double, 2> ends{-1.0, 1.0};

// Points of the rule on both sides.
std::vector<Point> list_points() {
    std::vector<Point> points;
    for (const KronrodPoint& point : find_kronrod_rule(gauss_points)) {
        points.push_back({point.xi, point.weight, point.gauss_weight});
        if (point.xi != 0.0) points.push_back({-point.xi, point.weight, point.gauss_weight});
    }
    for (Point& point : points) {
        for (const Point& other : points) {
            if (other.xi == point.xi) continue;
            for (std::size_t i = 0; i < ends.size(); ++i)
                point.to_ends[i] *= (ends[i] - other.xi) / (point.xi - other.xi);
        }
    }
    return points;
}

// A kink or a jump nearer to an end than all points, as where a stop is hardly touched, shows in the force at
// the end alone: it is compared with that of the polynomial through the points.
Integral apply_rule(const SpringLaw& law, double from, double to) {
    static const std::vector<Point> points = list_points();
    const double end_part = 1.0 - std::ranges::max(points, {}, &Point::xi).xi;
    const double centre = 0.5 * (from + to);
    const double half = 0.5 * (to - from);
    double kronrod = 0.0;
    double gauss = 0.0;
    double size = 0.0;
    std::array<double, 2> at_ends{};
    for (const Point& point : points) {
        const double force = law(centre + half * point.xi, 0.0);
        kronrod += point.weight * force;
        gauss += point.gauss_weight * force;
        size += point.weight * std::abs(force);
        for (std::size_t i = 0; i < ends.size(); ++i) at_ends[i] += point.to_ends[i] * force;
    }
    double unseen = 0.0;
    for (std::size_t i = 0; i < ends.size(); ++i) {
        const double force = law(centre + half * ends[i], 0.0);
        unseen += end_part * std::abs(force - at_ends[i]);
        size += end_part * std::abs(force);
    }
    return {
        half * kronrod, std::abs(half) * std::max(std::abs(kronrod - gauss), unseen), std::abs(half) * size};
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
