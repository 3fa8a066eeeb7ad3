#pragma once

#include <cstdint>

namespace gxrod {

// Where the next step ends: equal nominal steps from 0 to end_time, halved while they fail and doubled again
// as soon as they fit the grid. Times are fractions of end_time counted in whole ticks, so that the grid is
// met exactly.
class StepControl {
  public:
    StepControl(double end_time, long nominal_steps);

    double time() const { return at(position_); }
    double next_time() const { return at(position_ + span_); }
    double time_step() const { return nominal_step_ * static_cast<double>(span_) / ticks_per_step; }
    bool finished() const { return position_ >= end_; }

    // The step was accepted.
    void accept();
    // The step failed: halves it. False if it is already as short as it may be.
    bool reject();

    // Whether the accepted time lies on the nominal grid, and where.
    bool at_nominal_step() const { return position_ % ticks_per_step == 0; }
    long nominal_steps_done() const { return static_cast<long>(position_ / ticks_per_step); }
    long nominal_steps() const { return static_cast<long>(end_ / ticks_per_step); }

  private:
    static constexpr std::int64_t ticks_per_step = 1024;  // the shortest step is a 1024th of the nominal one

    double at(std::int64_t tick) const {
        return tick == end_ ? end_time_ : end_time_ * (static_cast<double>(tick) / static_cast<double>(end_));
    }

    double end_time_;
    double nominal_step_;
    std::int64_t end_;
    std::int64_t position_ = 0;
    std::int64_t span_ = ticks_per_step;
};

}  // namespace gxrod
