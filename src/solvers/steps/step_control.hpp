#pragma once

#include <optional>

#include "solvers/steps/step_grid.hpp"
#include "solvers/steps/step_sequence.hpp"

namespace gxrod {

// Equal nominal steps from 0 to end_time, halved while they fail and doubled again as soon as they fit the
// grid. Times are counted in whole ticks, so that the grid is met exactly. After a step that ends between its
// times, the next one ends at the next nominal time.
class StepControl : public StepSequence {
  public:
    // Takes the number of halvings from the nominal step to the shortest one.
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

    // Counts whole nominal steps; frames stand where nominal steps end.
    long steps_done() const override { return static_cast<long>(position_ / grid_.ticks()); }
    long steps_in_all() const override { return static_cast<long>(end_ / grid_.ticks()); }
    double part_done() const override {
        return static_cast<double>(steps_done()) / static_cast<double>(steps_in_all());
    }
    bool is_frame_due(long every) const override { return at_nominal_step() && steps_done() % every == 0; }

    StepMemory memory() const override;
    bool resume(const StepMemory& memory) override;

    // Returns whether the accepted time lies on the nominal grid.
    bool at_nominal_step() const { return !off_grid_ && position_ % grid_.ticks() == 0; }

  private:
    // Returns the length by which a step may be longer or shorter, so that no shorter step is left over.
    double sliver() const { return 1e-3 * grid_.step(); }
    bool lands_next() const { return landing_ && *landing_ <= at(position_ + span_) + sliver(); }
    // Returns the longest span that the grid allows from here.
    std::int64_t longest_span() const;
    // Makes this the accepted time; if it is off the grid, the next step ends at the next nominal time.
    void go_to(double time);
    double at(std::int64_t position) const { return position == end_ ? end_time_ : grid_.at(position); }

    double end_time_;
    StepGrid grid_;
    std::int64_t end_;
    std::int64_t position_ = 0;
    std::int64_t span_;
    bool has_failed_ = false;         // whether the shortest step failed
    std::optional<double> landing_;   // a later time at which a step is to end
    std::optional<double> off_grid_;  // the accepted time if it is after position_, before the next tick
};

}  // namespace gxrod
