#pragma once

#include <cstdint>

namespace gxrod {

// The times i × step, as near to what a user would write as doubles are: of a step that is a fraction p/q of
// small whole numbers, (i p)/q rounded once, so that ten steps of 0.1 end at 1 and a load that switches at
// 2.5 does so at a step. They do not depend on where a run ends.
class StepGrid {
  public:
    // Each step is cut into `ticks`; positions are counted in them.
    StepGrid(double step, std::int64_t ticks);

    double at(std::int64_t position) const;
    // The nearest position, and whether it is this time but for rounding.
    struct Place {
        std::int64_t position;
        bool is_exact;
    };
    Place find(double time) const;

    // p/q rounded once, whatever rounding the step came with.
    double step() const { return step_; }
    std::int64_t ticks() const { return ticks_; }

  private:
    double step_;
    std::int64_t ticks_;
    double numerator_, denominator_;  // of the step; step and 1 if it is not a small fraction
};

}  // namespace gxrod
