#pragma once

#include <array>

namespace gxrod {

// A piece of time.
struct TimeSpan {
    double start, length;
};

inline constexpr int difference_points = 7;

// How the derivatives of a function at one time follow from its values at seven times within a span, both
// ends among them: those of the polynomial of degree 6 through its values at the Chebyshev points.
// Derivatives are taken within the span alone, so that a corner at one of its ends does no harm.
struct StepDifferences {
    std::array<double, difference_points> times;
    std::array<double, difference_points> first;   // weights of the values in the first derivative
    std::array<double, difference_points> second;  // and in the second
};

StepDifferences compute_step_differences(double time, const TimeSpan& span);

}  // namespace gxrod
