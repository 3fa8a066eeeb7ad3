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
    // Takes times relative to `origin` of the axis.
    TimeSeries(std::vector<double> times, double origin) : times_(std::move(times)), origin_(origin) {}

    // Counts the times that have been reached at this time. Rounding is ignored: a time at which a step ends
    // belongs to that step.
    std::int64_t count(double time) const;
    double at(std::int64_t index) const;

  private:
    std::optional<StepGrid> grid_;
    std::vector<double> times_;
    double origin_ = 0.0;
};

// Output that is due at a time.
struct DueOutput {
    double time;
    bool is_frame;
    bool is_sample;  // whether a sample of histories is due
};

// Frames and samples of histories that a deck asks for at given times, in t of a stage. They depend on the
// times alone, so a resumed run has the same ones.
class OutputSchedule {
  public:
    // Makes a schedule on which nothing is due.
    OutputSchedule() = default;
    // Makes the schedule of a stage with time that begins at `axis_start` on the axis that stages share.
    OutputSchedule(const OutputSettings& output, double axis_start);

    bool is_empty() const { return !frames_ && !samples_; }
    bool has_frames() const { return frames_.has_value(); }
    // Returns what is due at its beginning, unless an earlier stage with time ends there.
    DueOutput list_start() const;
    // Lists what is due within a step between these times, in order. The last entry is the end of the step,
    // whether anything is due there or not.
    std::vector<DueOutput> list(double from, double to) const;
    // Returns whether something is due before the end.
    bool has_inner(double from, double to) const { return list(from, to).size() > 1; }

  private:
    std::optional<TimeSeries> frames_, samples_;
};

}  // namespace gxrod
