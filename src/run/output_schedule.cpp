#include "run/output_schedule.hpp"

#include <algorithm>
#include <cmath>

namespace gxrod {

namespace {

// Relative: nearer than that, times are the same.
constexpr double rounding = 1e-12;

bool is_reached(double time, double now) { return time <= now + rounding * std::abs(now); }

}  // namespace

std::int64_t TimeSeries::count(double time) const {
    if (!grid_) {
        const auto reached = [now = origin_ + time](double each) { return is_reached(each, now); };
        return std::ranges::partition_point(times_, reached) - times_.begin();
    }
    std::int64_t last = grid_->find(time).position;
    while (is_reached(grid_->at(last + 1), time)) ++last;
    while (last >= 0 && !is_reached(grid_->at(last), time)) --last;
    return last + 1;
}

double TimeSeries::at(std::int64_t index) const {
    return grid_ ? grid_->at(index) : times_[static_cast<std::size_t>(index)] - origin_;
}

OutputSchedule::OutputSchedule(const OutputSettings& output, double axis_start) {
    if (output.interval) {
        frames_.emplace(*output.interval);
    } else if (!output.times.empty()) {
        frames_.emplace(output.times, axis_start);
    }
    if (output.history_interval) samples_.emplace(*output.history_interval);
}

DueOutput OutputSchedule::list_start() const {
    return {0.0, frames_ && frames_->count(0.0) > 0, samples_.has_value()};
}

std::vector<DueOutput> OutputSchedule::list(double from, double to) const {
    std::vector<DueOutput> due;
    const auto add = [&](const std::optional<TimeSeries>& series, bool DueOutput::*kind) {
        if (!series) return;
        for (std::int64_t i = series->count(from); i < series->count(to); ++i) {
            const double time = series->at(i);
            const bool is_end = time >= to || is_reached(to, time);
            due.push_back({is_end ? to : time, false, false});
            due.back().*kind = true;
        }
    };
    add(frames_, &DueOutput::is_frame);
    add(samples_, &DueOutput::is_sample);
    due.push_back({to, false, false});
    std::ranges::stable_sort(due, {}, &DueOutput::time);
    std::vector<DueOutput> merged;
    for (const DueOutput& each : due) {
        if (merged.empty() || merged.back().time != each.time) merged.push_back({each.time, false, false});
        merged.back().is_frame |= each.is_frame;
        merged.back().is_sample |= each.is_sample;
    }
    return merged;
}

}  // namespace gxrod
