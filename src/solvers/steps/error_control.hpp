#pragma once

#include <optional>

#include "model/settings/settings.hpp"
#include "solvers/steps/step_sequence.hpp"

namespace gxrod {

// Steps from 0 to end_time whose estimated error stays below a tolerance, by a proportional-integral
// controller (Gustafsson 1991; Hairer & Wanner 1996, IV.2): the next step is
//   Δt × safety × (tolerance / error)^(0.7/order) × (error before / tolerance)^(0.4/order),
// at most 3 times the last one and no longer right after a rejection. A step with too large an error is
// repeated with a shorter one, a step that fails for another reason with half. The last steps are stretched
// to end at end_time.
class ErrorControl : public StepSequence {
  public:
    // The error estimate falls with the power `order` of the step. The settings' min_step bounds steps after
    // rejections; the last step may be shorter.
    ErrorControl(double end_time, double first_step, int order, const AdaptiveSettings& settings);

    double time() const override { return time_; }
    double next_time() const override { return next_time_; }
    double time_step() const override { return step_; }
    bool finished() const override { return time_ >= end_time_; }

    bool needs_error() const override { return true; }
    bool admits(double error) override;
    std::optional<double> land_on(double time) override;
    void accept() override;
    bool reject() override;

    long steps_done() const override { return accepted_; }
    long steps_in_all() const override { return 0; }
    double part_done() const override { return time_ / end_time_; }
    bool is_frame_due(long every) const override { return accepted_ % every == 0; }

    // Returns the memory before any rejection since the last accepted step.
    StepMemory memory() const override { return memory_; }
    bool resume(const StepMemory& memory) override;

  private:
    // Sets the next step to this length, or a length that fits before the end.
    void plan(double step);
    void remember() {
        memory_ = {.time = time_,
                   .step = wanted_,
                   .error_before = error_before_,
                   .just_rejected = just_rejected_,
                   .accepted = accepted_};
    }

    double end_time_;
    double order_;
    double tolerance_;
    double shortest_, longest_;
    double time_ = 0.0;
    double step_ = 0.0;
    double wanted_ = 0.0;  // step_ before it was fitted to the time that is left
    double next_time_ = 0.0;
    std::optional<double> landing_;  // a time ahead at which a step is to end
    // Errors relative to the tolerance: of the step tried last, negative if not known, and of the step
    // accepted before.
    double error_ = -1.0;
    double error_before_ = -1.0;
    bool just_rejected_ = false;
    long accepted_ = 0;
    StepMemory memory_;
};

}  // namespace gxrod
