#include "model/time/transitions.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace gxrod {

namespace {

// Of the largest value; a jump.
constexpr double smallest_jump = 1e-9;
// Of the largest slope; a kink.
constexpr double smallest_kink = 1e-3;
// Of the smooth part next to a transition, for the difference quotient of its slope there.
constexpr double slope_step = 1e-3;
constexpr int fewest_parts = 64;

// How large values and slopes of a function are, by chords between evenly spread times and the breaks.
struct Sizes {
    double value = 0.0;
    double slope = 0.0;
};

Sizes measure(const TimeFunction& function, const Interval& times, const std::vector<double>& breaks) {
    std::vector<double> at = breaks;
    for (int i = 0; i <= fewest_parts; ++i)
        at.push_back(times.from + (times.to - times.from) * i / fewest_parts);
    std::sort(at.begin(), at.end());
    Sizes sizes;
    double before = 0.0;
    for (std::size_t i = 0; i < at.size(); ++i) {
        const double value = function(at[i]);
        sizes.value = std::max(sizes.value, std::abs(value));
        if (i > 0 && at[i] > at[i - 1]) {
            sizes.slope = std::max(sizes.slope, std::abs(value - before) / (at[i] - at[i - 1]));
        }
        before = value;
    }
    return sizes;
}

class Sides {
  public:
    Sides(const TimeFunction& function, const Interval& times)
        : function_(function),
          nearest_(8.0 * std::numeric_limits<double>::epsilon() *
                   std::max(std::abs(times.from), std::abs(times.to))) {}

    double value_before(double at) const { return function_(at - nearest_); }
    double value_after(double at) const { return function_(at + nearest_); }
    // From three values on one side, the smooth part there being as long as `part`.
    double slope_before(double at, double part) const { return -slope(at, -slope_step * part, -nearest_); }
    double slope_after(double at, double part) const { return slope(at, slope_step * part, nearest_); }
    double nearest() const { return nearest_; }

  private:
    double slope(double at, double step, double first) const {
        const double width = std::abs(step);
        return (4.0 * function_(at + step) - function_(at + 2.0 * step) - 3.0 * function_(at + first)) /
               (2.0 * width);
    }

    const TimeFunction& function_;
    double nearest_;
};

}  // namespace

std::vector<Transition> find_transitions(const TimeFunction& function, const Interval& times, int samples) {
    if (function.switches() == nullptr || !(times.to > times.from)) return {};
    const std::vector<double> breaks = find_breaks_in_time(*function.switches(), times, samples);
    Sizes sizes = measure(function, times, breaks);
    const Sides sides(function, times);
    std::vector<double> places{times.from};
    places.insert(places.end(), breaks.begin(), breaks.end());
    places.push_back(times.to);
    std::vector<Transition> all;
    for (std::size_t i = 0; i < places.size(); ++i) {
        const bool is_first = i == 0;
        const bool is_last = i + 1 == places.size();
        Transition here;
        here.time = places[i];
        here.value_before = is_first ? function(places[i]) : sides.value_before(places[i]);
        here.value_after = is_last ? function(places[i]) : sides.value_after(places[i]);
        if (!is_first) here.slope_before = sides.slope_before(places[i], places[i] - places[i - 1]);
        if (!is_last) here.slope_after = sides.slope_after(places[i], places[i + 1] - places[i]);
        if (is_first) here.slope_before = here.slope_after;
        if (is_last) here.slope_after = here.slope_before;
        sizes.slope = std::max({sizes.slope, std::abs(here.slope_before), std::abs(here.slope_after)});
        all.push_back(here);
    }
    for (Transition& here : all) {
        const double own_slope = std::max(std::abs(here.slope_before), std::abs(here.slope_after));
        const double jump = std::abs(here.value_after - here.value_before);
        here.is_jump = jump > smallest_jump * sizes.value + 4.0 * sides.nearest() * own_slope;
        here.is_kink =
            !here.is_jump && std::abs(here.slope_after - here.slope_before) > smallest_kink * sizes.slope;
    }
    std::erase_if(all, [](const Transition& here) { return !here.is_jump && !here.is_kink; });
    return all;
}

}  // namespace gxrod
