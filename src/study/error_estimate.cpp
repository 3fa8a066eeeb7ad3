#include "study/error_estimate.hpp"

#include <algorithm>
#include <cmath>

namespace gxrod {

namespace {

// Below it, differences do not fall as errors that vanish do.
constexpr double least_order = 0.5;

}  // namespace

double largest_of(const std::vector<double>& values) {
    double most = 0.0;
    for (const double value : values) most = std::fmax(most, value);
    return most;
}

double ErrorEstimate::largest() const { return largest_of(errors); }

ErrorEstimate estimate_error(const std::vector<std::vector<double>>& differences,
                             double expected_order,
                             double floor) {
    ErrorEstimate estimate;
    for (const std::vector<double>& level : differences) estimate.differences.push_back(largest_of(level));
    if (differences.empty()) return estimate;
    const double first = estimate.differences.front();
    estimate.errors = differences.front();
    if (first <= floor) {
        estimate.is_supported = estimate.is_round_off = largest_of(estimate.differences) <= floor;
        // What only a finer run meets, as a load between the steps of the others, the first difference hides.
        if (!estimate.is_round_off) estimate.errors = differences.back();
        return estimate;
    }
    if (differences.size() == 1) {
        const double growth = std::exp2(expected_order);
        for (double& error : estimate.errors) error *= growth / (growth - 1.0);
        return estimate;
    }
    const double second = estimate.differences[1];
    if (second > floor) estimate.order = std::log2(first / second);
    estimate.is_supported = !estimate.order || *estimate.order >= least_order;
    // From the finer solution on, the method's order, or less if less is seen.
    const double order = std::clamp(estimate.order.value_or(expected_order), least_order, expected_order);
    const double growth = std::exp2(order);
    const std::size_t samples = std::min(estimate.errors.size(), differences[1].size());
    estimate.errors.resize(samples);
    for (std::size_t i = 0; i < samples; ++i)
        estimate.errors[i] += differences[1][i] * growth / (growth - 1.0);
    return estimate;
}

}  // namespace gxrod
