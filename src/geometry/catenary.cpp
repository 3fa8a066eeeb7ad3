#include "geometry/catenary.hpp"

namespace gxrod {

namespace {

constexpr int most_iterations = 100;

struct Value {
    double value, slope;
};

// ln(sinh x / x); of small x by sinh x / x − 1 = Σ x²ⁿ/(2n + 1)!, n ≥ 1, of which nothing cancels.
Value log_of_ratio(double x) {
    // sinh x = ½ eˣ (1 − e^{−2x}).
    if (x > 2.0)
        return {x - std::log(2.0 * x) + std::log1p(-std::exp(-2.0 * x)), 1.0 / std::tanh(x) - 1.0 / x};
    double sum = 0.0, slope = 0.0, term = 1.0;
    for (int n = 1; n <= 14; ++n) {
        term *= x * x / (2.0 * n * (2.0 * n + 1.0));
        sum += term;
        slope += 2.0 * n * term / x;
    }
    return {std::log1p(sum), slope / (1.0 + sum)};
}

}  // namespace

double find_catenary_argument(double log_ratio) {
    // The function is convex and at most x²/6: this is too small, after one step of Newton's method x is too
    // large and falls from then on.
    double x = std::sqrt(6.0 * log_ratio);
    for (int i = 0; i < most_iterations; ++i) {
        const Value at = log_of_ratio(x);
        const double change = (at.value - log_ratio) / at.slope;
        x -= change;
        if (std::abs(change) <= 2e-16 * x) break;
    }
    return x;
}

}  // namespace gxrod
