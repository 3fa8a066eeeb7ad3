#include "contact/restitution.hpp"

#include <cmath>

namespace gxrod {
namespace {

// x − ln(1 + x) without the loss of digits near 0.
double lag_of_logarithm(double x) {
    if (std::abs(x) > 0.1) return x - std::log1p(x);
    double sum = 0.0;
    for (int k = 20; k >= 2; --k) sum = (k % 2 == 0 ? 1.0 : -1.0) / k + x * sum;
    return x * x * sum;
}

}  // namespace

double find_damping_number(double restitution) {
    if (restitution >= 1.0) return 0.0;
    // The difference of both sides is above 0 below the root, and falls to −∞ at c = 1/e.
    double low = 0.0, high = 1.0 / restitution;
    for (int halving = 0; halving < 200; ++halving) {
        const double middle = 0.5 * (low + high);
        if (middle <= low || middle >= high) break;
        const double excess = lag_of_logarithm(middle) - lag_of_logarithm(-restitution * middle);
        (excess > 0.0 ? low : high) = middle;
    }
    return 0.5 * (low + high);
}

}  // namespace gxrod
