#include "environment/dispersion.hpp"

#include <cmath>

namespace gxrod {

namespace {

constexpr int most_iterations = 50;

}  // namespace

double find_wave_number(double frequency, std::optional<double> depth, double gravity) {
    const double deep = frequency * frequency / gravity;
    if (!depth) return deep;
    // x tanh x = y, x = kd. Both starts are from above, the left side is convex there: Newton's method falls.
    const double y = deep * *depth;
    double x = y > 1.0 ? y / std::tanh(y) : std::sqrt(y) * (1.0 + 0.25 * y);
    for (int i = 0; i < most_iterations; ++i) {
        const double tangent = std::tanh(x);
        const double change = (x * tangent - y) / (tangent + x * (1.0 - tangent) * (1.0 + tangent));
        x -= change;
        if (std::abs(change) < 1e-15 * x) break;
    }
    return x / *depth;
}

}  // namespace gxrod
