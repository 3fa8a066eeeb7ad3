#pragma once

#include <cstdint>

namespace gxrod {

// The times i × step, as near as doubles are to the times that a user would write: if the step is a fraction
// p/q of small whole numbers, (i p)/q rounded once, so that ten steps of 0.1 end at 1, and a load that
// switches at 2.5 does so at a step. They do not depend on the end of a run.
class StepGrid {
  public:
    // Divides each step into `ticks`, in which positions are counted.
    StepGrid(double step, std::int64_t ticks);

    double at(std::int64_t position) const;
    // The nearest position to a time, and whether they are equal to rounding.
    struct Place {
        std::int64_t position;
        bool is_exact;
    };
    Place find(double time) const;

    // Returns p/q rounded once, whatever rounding the given step had.
    double step() const { return step_; }
    std::int64_t ticks() const { return ticks_; }

  private:
    double step_;
    std::int64_t ticks_;
    double numerator_, denominator_;  // fraction of the step; step and 1 if it is not a small fraction
};

}  // namespace gxrod
