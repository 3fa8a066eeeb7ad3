#include "constraints/step_differences.hpp"

#include <cmath>
#include <numbers>

namespace gxrod {

namespace {

using Points = std::array<double, difference_points>;

// Of the span's length, from its start.
Points compute_chebyshev_points() {
    Points at;
    for (int i = 0; i < difference_points; ++i) {
        at[i] = 0.5 * (1.0 - std::cos(i * std::numbers::pi / (difference_points - 1)));
    }
    return at;
}

// The product over all points but i, k and l of (x − x_j)/(x_i − x_j).
double compute_product(const Points& at, double x, int i, int k, int l) {
    double product = 1.0;
    for (int j = 0; j < difference_points; ++j) {
        if (j != i && j != k && j != l) product *= (x - at[j]) / (at[i] - at[j]);
    }
    return product;
}

}  // namespace

StepDifferences compute_step_differences(double time, const TimeSpan& span) {
    const Points at = compute_chebyshev_points();
    const double x = (time - span.start) / span.length;
    StepDifferences differences{{}, {}, {}};
    for (int i = 0; i < difference_points; ++i) {
        differences.times[i] = span.start + at[i] * span.length;
        for (int k = 0; k < difference_points; ++k) {
            if (k == i) continue;
            const double factor = 1.0 / ((at[i] - at[k]) * span.length);
            differences.first[i] += factor * compute_product(at, x, i, k, k);
            for (int l = 0; l < difference_points; ++l) {
                if (l == i || l == k) continue;
                differences.second[i] +=
                    factor / ((at[i] - at[l]) * span.length) * compute_product(at, x, i, k, l);
            }
        }
    }
    return differences;
}

}  // namespace gxrod
