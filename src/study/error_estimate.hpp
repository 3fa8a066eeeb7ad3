#pragma once

#include <optional>
#include <vector>

namespace gxrod {

// The error of a coarse solution, from its differences to finer ones (Richardson 1911): where halving the
// step makes the error 2^p times less, the error is that difference times 2^p / (2^p − 1).
struct ErrorEstimate {
    // The largest difference between one level and the next finer one.
    std::vector<double> differences;
    // p as seen, of two differences above what is round-off; else none.
    std::optional<double> order;
    // Of the coarsest solution at each sample.
    std::vector<double> errors;
    // Whether the order seen, or that the last difference is round-off, supports the estimate.
    bool is_supported = false;
    // Whether it is nothing but round-off.
    bool is_round_off = false;

    bool is_known() const { return !differences.empty(); }
    double largest() const;
};

// Errors below this part of a tolerance do not matter, however they fall.
inline constexpr double negligible = 0.1;

double largest_of(const std::vector<double>& values);  // 0 of none

// From the differences level by level, one at each sample, coarse to fine. `expected_order` is that of the
// method; differences up to `floor` are round-off.
ErrorEstimate estimate_error(const std::vector<std::vector<double>>& differences,
                             double expected_order,
                             double floor);

}  // namespace gxrod
