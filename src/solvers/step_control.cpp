#include "solvers/step_control.hpp"

namespace gxrod {

StepControl::StepControl(double end_time, long nominal_steps, int halvings)
    : end_time_(end_time),
      grid_(end_time / static_cast<double>(nominal_steps), std::int64_t{1} << halvings),
      end_(nominal_steps * grid_.ticks()),
      span_(grid_.ticks()) {}

void StepControl::accept() {
    position_ += span_;
    while (span_ < grid_.ticks() && position_ % (2 * span_) == 0) span_ *= 2;
}

bool StepControl::reject() {
    if (span_ == 1) return false;
    span_ /= 2;
    return true;
}

StepMemory StepControl::memory() const {
    StepMemory memory;
    memory.time = time();
    return memory;
}

// The next step is the longest that fits the grid, as it always is after an accepted one.
bool StepControl::resume(const StepMemory& memory) {
    const StepGrid::Place place = grid_.find(memory.time);
    if (!place.is_exact || place.position > end_) return false;
    position_ = place.position;
    span_ = grid_.ticks();
    while (position_ % span_ != 0) span_ /= 2;
    return true;
}

}  // namespace gxrod
