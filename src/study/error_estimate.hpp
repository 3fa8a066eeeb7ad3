#pragma once

#include <optional>
#include <vector>

namespace gxrod {

// The error of a coarse solution, from its differences to finer ones (Richardson 1911): if halving the step
// makes the error 2^p times smaller, the error is the difference times 2^p / (2^p − 1).
struct ErrorEstimate {
    // The largest difference between one level and the next finer one.
    std::vector<double> differences;
    // p as observed from two differences above round-off; else none.
    std::optional<double> order;
    // Errors of the coarsest solution at each sample.
    std::vector<double> errors;
    // Whether the estimate is supported by the observed order, or by a last difference within round-off.
    bool is_supported = false;
    // Whether the error is only round-off.
    bool is_round_off = false;

    bool is_known() const { return !differences.empty(); }
    double largest() const;
};

// Errors below this part of a tolerance do not matter, whatever their order.
inline constexpr double negligible = 0.1;

double largest_of(const std::vector<double>& values);  // 0 if empty

// Estimates the error from the differences of each level at each sample, coarse to fine. `expected_order` is
// the order of the method; differences up to `floor` are round-off.
ErrorEstimate estimate_error(const std::vector<std::vector<double>>& differences,
                             double expected_order,
                             double floor);

}  // namespace gxrod
