#pragma once

#include <algorithm>
#include <cmath>
#include <utility>

namespace gxrod {

// The place where a function that does not fall changes its sign, between two numbers next to each other.
struct RisingRoot {
    double best = 0.0;  // the smaller absolute value
    double below = 0.0, above = 0.0;
    double gap = 0.0;       // the difference of the values there
    bool is_never = false;  // all values are negative
};

// Finds it from a first interval, which is widened as far as `most`. Values can be −∞. Ends where an absolute
// value is at most `tolerance`, or the interval is no longer than `resolution`.
template <class Function>
RisingRoot find_rising_root(
    Function&& function, std::pair<double, double> first, double most, double tolerance, double resolution) {
    constexpr int most_steps = 400, most_widenings = 60;
    auto [low, high] = first;
    double width = high - low;
    double at_low = function(low), at_high = function(high);
    const auto is_small = [&](double value) { return std::abs(value) <= tolerance; };
    for (int i = 0; i < most_widenings && at_low > tolerance; ++i, width *= 2.0) {
        high = std::exchange(low, low - width);
        at_high = std::exchange(at_low, function(low));
    }
    for (int i = 0; i < most_widenings && at_high < -tolerance && high < most; ++i, width *= 2.0) {
        low = std::exchange(high, std::min(most, high + width));
        at_low = std::exchange(at_high, function(high));
    }
    if (is_small(at_high)) return {high, high, high};
    if (at_high < 0.0) return {high, high, high, 0.0, true};
    if (is_small(at_low)) return {low, low, low};
    // Regula falsi in the manner of Illinois, and every third step a bisection.
    double weight_low = at_low, weight_high = at_high;
    for (int i = 0; i < most_steps && high - low > resolution; ++i) {
        double at = 0.5 * (low + high);
        if (i % 3 != 2 && std::isfinite(weight_low))
            at = low + (high - low) * (-weight_low / (weight_high - weight_low));
        if (!(at > low && at < high)) at = 0.5 * (low + high);
        if (!(at > low && at < high)) break;
        const double value = function(at);
        if (is_small(value)) return {at, at, at};
        if (value < 0.0) {
            low = at;
            at_low = weight_low = value;
            weight_high *= 0.5;
        } else {
            high = at;
            at_high = weight_high = value;
            weight_low *= 0.5;
        }
    }
    const bool is_high_best = !(std::abs(at_low) < std::abs(at_high));
    return {is_high_best ? high : low, low, high, at_high - at_low};
}

}  // namespace gxrod
