#include "solvers/step_control.hpp"

namespace gxrod {

StepControl::StepControl(double end_time, long nominal_steps, int halvings)
    : end_time_(end_time),
      nominal_step_(end_time / static_cast<double>(nominal_steps)),
      ticks_per_step_(std::int64_t{1} << halvings),
      end_(nominal_steps * ticks_per_step_),
      span_(ticks_per_step_) {}

void StepControl::accept() {
    position_ += span_;
    while (span_ < ticks_per_step_ && position_ % (2 * span_) == 0) span_ *= 2;
}

bool StepControl::reject() {
    if (span_ == 1) return false;
    span_ /= 2;
    return true;
}

}  // namespace gxrod
