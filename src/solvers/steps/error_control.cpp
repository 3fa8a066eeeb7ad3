#include "solvers/steps/error_control.hpp"

#include <algorithm>
#include <cmath>

namespace gxrod {

namespace {

constexpr double safety = 0.9;
constexpr double largest_growth = 3.0;
constexpr double largest_cut = 0.2;
constexpr double smallest_error = 1e-10;  // of what is aimed at; below, an error counts as this
// An error before counts as no smaller than this, or the step would shrink after a quiet phase for no reason.
constexpr double smallest_error_before = 1e-2;
constexpr double least_of_end_time = 1e-12;  // no step is shorter, whatever min_step says

}  // namespace

ErrorControl::ErrorControl(double end_time, double first_step, int order, const AdaptiveSettings& settings)
    : end_time_(end_time),
      order_(order),
      tolerance_(settings.tolerance),
      shortest_(std::max(settings.min_step, least_of_end_time * end_time)),
      longest_(std::max(settings.max_step, shortest_)) {
    plan(first_step);
    remember();
}

void ErrorControl::plan(double step) {
    wanted_ = step_ = std::clamp(step, shortest_, longest_);
    const double goal = landing_.value_or(end_time_);
    const double left = goal - time_;
    // Never a sliver before the end: the last two steps share what is left.
    if (step_ >= left * (1.0 - 1e-10)) {
        step_ = left;
        next_time_ = goal;
        return;
    }
    if (2.0 * step_ > left) step_ = 0.5 * left;
    next_time_ = time_ + step_;
}

std::optional<double> ErrorControl::land_on(double time) {
    if (time < time_ || time > end_time_) return std::nullopt;
    landing_.reset();
    if (time > time_) landing_ = time;
    plan(wanted_);
    return time;
}

bool ErrorControl::admits(double error) {
    error_ = error / tolerance_;
    return error_ <= 1.0;
}

void ErrorControl::accept() {
    const double error = std::max(error_ / std::pow(safety, order_), smallest_error);
    const double factor = error_before_ > 0.0
                              ? std::pow(error, -0.7 / order_) * std::pow(error_before_, 0.4 / order_)
                              : std::pow(error, -1.0 / order_);
    const double growth = just_rejected_ ? 1.0 : largest_growth;
    time_ = next_time_;
    ++accepted_;
    error_before_ = std::max(error, smallest_error_before);
    error_ = -1.0;
    just_rejected_ = false;
    double next = step_ * std::clamp(factor, largest_cut, growth);
    if (landing_ && time_ >= *landing_) {
        landing_.reset();
        next = std::max(next, wanted_);  // a step that had to end there says little about the next one
    }
    plan(next);
    remember();
}

bool ErrorControl::reject() {
    if (step_ <= shortest_) return false;
    const double by_error = safety * std::pow(error_, -1.0 / order_);
    const double factor = error_ > 1.0 ? std::clamp(by_error, largest_cut, safety) : 0.5;
    error_ = error_before_ = -1.0;
    just_rejected_ = true;
    plan(std::max(step_ * factor, shortest_));
    return true;
}

bool ErrorControl::resume(const StepMemory& memory) {
    if (memory.time > end_time_) return false;
    landing_.reset();
    time_ = memory.time;
    error_before_ = memory.error_before;
    just_rejected_ = memory.just_rejected;
    accepted_ = static_cast<long>(memory.accepted);
    // Steps before were equal ones: then the first step as the settings have it.
    plan(memory.step > 0.0 ? memory.step : wanted_);
    remember();
    return true;
}

}  // namespace gxrod
