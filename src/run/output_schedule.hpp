#pragma once

#include <optional>
#include <vector>

#include "model/settings/settings.hpp"
#include "solvers/steps/step_grid.hpp"

namespace gxrod {

// Ascending times: the multiples of an interval, from 0, or listed ones.
class TimeSeries {
  public:
    explicit TimeSeries(double interval) : grid_(std::in_place, interval, 1) {}
    // Times of an axis on which 0 is at `origin`.
    TimeSeries(std::vector<double> times, double origin) : times_(std::move(times)), origin_(origin) {}

    // How many of them have been reached at this time; but for rounding, so that one at which a step ends
    // belongs to that step.
    std::int64_t count(double time) const;
    double at(std::int64_t index) const;

  private:
    std::optional<StepGrid> grid_;
    std::vector<double> times_;
    double origin_ = 0.0;
};

// What is due at a time.
struct DueOutput {
    double time;
    bool is_frame;
    bool is_sample;  // of histories
};

// Frames and samples of histories that a deck asks for at times of its own, in t of a stage. They depend on
// the times alone, so that a run that was resumed has the same.
class OutputSchedule {
  public:
    // Nothing is due by default.
    OutputSchedule() = default;
    // Of a stage with time that begins there on the axis that stages share.
    OutputSchedule(const OutputSettings& output, double axis_start);

    bool is_empty() const { return !frames_ && !samples_; }
    bool has_frames() const { return frames_.has_value(); }
    // What is due where it begins, if a stage with time before it does not end there.
    DueOutput list_start() const;
    // Within a step between these times, its end included, in order; that is the last entry, whether anything
    // is due or not.
    std::vector<DueOutput> list(double from, double to) const;
    // Whether something is due before the end.
    bool has_inner(double from, double to) const { return list(from, to).size() > 1; }

  private:
    std::optional<TimeSeries> frames_, samples_;
};

}  // namespace gxrod
