#pragma once

#include <optional>

#include "solvers/steps/step_grid.hpp"
#include "solvers/steps/step_sequence.hpp"

namespace gxrod {

// Where the next step ends: equal nominal steps from 0 to end_time, halved while they fail and doubled again
// as soon as they fit the grid. Times are counted in whole ticks, so that the grid is met exactly. A step
// that lands between its times is followed by one to the next nominal time.
class StepControl : public StepSequence {
  public:
    // The shortest step is the nominal one halved so many times.
    StepControl(double end_time, long nominal_steps, int halvings = 10);

    double time() const override { return off_grid_.value_or(at(position_)); }
    double next_time() const override { return lands_next() ? *landing_ : at(position_ + span_); }
    double time_step() const override {
        if (off_grid_ || lands_next()) return next_time() - time();
        return grid_.step() * static_cast<double>(span_) / static_cast<double>(grid_.ticks());
    }
    bool finished() const override { return position_ >= end_; }

    std::optional<double> land_on(double time) override;
    void accept() override;
    bool reject() override;

    // Nominal steps; parts of one do not count, and frames stand where nominal steps end.
    long steps_done() const override { return static_cast<long>(position_ / grid_.ticks()); }
    long steps_in_all() const override { return static_cast<long>(end_ / grid_.ticks()); }
    double part_done() const override {
        return static_cast<double>(steps_done()) / static_cast<double>(steps_in_all());
    }
    bool is_frame_due(long every) const override { return at_nominal_step() && steps_done() % every == 0; }

    StepMemory memory() const override;
    bool resume(const StepMemory& memory) override;

    // Whether the accepted time lies on the nominal grid.
    bool at_nominal_step() const { return !off_grid_ && position_ % grid_.ticks() == 0; }

  private:
    // A step may be longer or shorter by so much of a nominal one, so that none is left that is shorter.
    double sliver() const { return 1e-3 * grid_.step(); }
    bool lands_next() const { return landing_ && *landing_ <= at(position_ + span_) + sliver(); }
    // That the grid allows from here.
    std::int64_t longest_span() const;
    // The accepted time is this one, with the next step to the next nominal time if it is off the grid.
    void go_to(double time);
    double at(std::int64_t position) const { return position == end_ ? end_time_ : grid_.at(position); }

    double end_time_;
    StepGrid grid_;
    std::int64_t end_;
    std::int64_t position_ = 0;
    std::int64_t span_;
    bool has_failed_ = false;         // the shortest step
    std::optional<double> landing_;   // a time ahead at which a step is to end
    std::optional<double> off_grid_;  // the accepted time if it is after position_, before the next tick
};

}  // namespace gxrod
