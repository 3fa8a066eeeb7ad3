#pragma once

#include <array>

namespace gxrod {

// An interval of time.
struct TimeSpan {
    double start, length;
};

inline constexpr int difference_points = 7;

// Weights that give the derivatives of a function at one time from its values at seven times within a span,
// including both ends: the derivatives of the polynomial of degree 6 through its values at the Chebyshev
// points. All times lie within the span, so that a corner at one of its ends does no harm.
struct StepDifferences {
    std::array<double, difference_points> times;
    std::array<double, difference_points> first;   // weights of the values for the first derivative
    std::array<double, difference_points> second;  // weights for the second derivative
};

StepDifferences compute_step_differences(double time, const TimeSpan& span);

}  // namespace gxrod
