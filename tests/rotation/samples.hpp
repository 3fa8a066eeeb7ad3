#pragma once

#include <array>
#include <cmath>
#include <limits>
#include <numbers>
#include <random>
#include <vector>

#include "rotation/coefficients.hpp"
#include "rotation/types.hpp"

// Inputs that the tests of the rotation room share.
namespace gxrod::samples {

// Seeded, so that a failure can be repeated.
class Random {
  public:
    explicit Random(unsigned seed) : engine_(seed) {}

    double between(double low, double high) {
        return std::uniform_real_distribution<double>(low, high)(engine_);
    }

    // Components of the order of one.
    Vec3 vector() {
        std::normal_distribution<double> normal;
        const double x = normal(engine_);
        const double y = normal(engine_);
        const double z = normal(engine_);
        return Vec3(x, y, z);
    }

    Vec3 direction() { return vector().normalized(); }

  private:
    std::mt19937_64 engine_;
};

inline double just_below(double value) { return std::nextafter(value, 0.0); }
inline double just_above(double value) {
    return std::nextafter(value, std::numeric_limits<double>::infinity());
}

// Every angle at which a coefficient changes from series to closed form.
inline std::vector<double> switch_angles() {
    const auto& s = coefficients::switches;
    return {s.b, s.a1, s.b1, s.c1, s.a2, s.b2, s.c2, s.d, s.d1};
}

// Angles in [0, π] where something could go wrong, and some where nothing should.
inline std::vector<double> angles_to_pi() {
    const double pi = std::numbers::pi;
    std::vector<double> angles = {
        0.0, 1e-300, 1e-160, 1e-16, 1e-12, 1e-9, 1e-8, 1e-4, 0.1, 0.5, 1.0, 1.5, 2.5, pi - 1e-4, pi - 1e-9};
    for (const double at : switch_angles()) {
        if (at > pi) continue;
        angles.insert(angles.end(), {just_below(at), at, just_above(at)});
    }
    angles.push_back(pi);
    return angles;
}

// The same, continued past π through the remaining switches.
inline std::vector<double> angles_past_pi() {
    std::vector<double> angles = angles_to_pi();
    for (const double at : switch_angles())
        if (at > std::numbers::pi) angles.insert(angles.end(), {just_below(at), at, just_above(at)});
    return angles;
}

// f'(0) by a central difference of sixth order, f a function of a number with values in a vector space.
template <typename Function>
auto central_difference(Function f, double step) {
    const auto first = (f(step) - f(-step)).eval();
    const auto second = (f(2.0 * step) - f(-2.0 * step)).eval();
    const auto third = (f(3.0 * step) - f(-3.0 * step)).eval();
    return ((45.0 * first - 9.0 * second + third) / (60.0 * step)).eval();
}

// The matrix of derivatives of f at x, f from Vec3 to Vec3.
template <typename Function>
Mat3 difference_jacobian(Function f, const Vec3& x, double step) {
    Mat3 result;
    for (int i = 0; i < 3; ++i)
        result.col(i) =
            central_difference([&](double t) -> Vec3 { return f(Vec3(x + t * Vec3::Unit(i))); }, step);
    return result;
}

}  // namespace gxrod::samples
