#include "solvers/step_control.hpp"

namespace gxrod {

StepControl::StepControl(double end_time, long nominal_steps, int halvings)
    : end_time_(end_time),
      grid_(end_time / static_cast<double>(nominal_steps), std::int64_t{1} << halvings),
      end_(nominal_steps * grid_.ticks()),
      span_(grid_.ticks()) {}

std::int64_t StepControl::longest_span() const {
    std::int64_t span = grid_.ticks();
    while (position_ % span != 0) span /= 2;
    return span;
}

void StepControl::accept() {
    position_ += span_;
    span_ = longest_span();
}

bool StepControl::reject() {
    has_failed_ = span_ == 1;
    if (!has_failed_) span_ /= 2;
    return !has_failed_;
}

StepMemory StepControl::memory() const {
    StepMemory memory;
    memory.time = time();
    memory.has_failed = has_failed_;
    return memory;
}

// The next step is the longest that fits the grid, as after any accepted one; but where the shortest one
// failed, a whole one to the next nominal time is tried: settings can have changed.
bool StepControl::resume(const StepMemory& memory) {
    const StepGrid::Place place = grid_.find(memory.time);
    if (!place.is_exact || place.position > end_) return false;
    position_ = place.position;
    span_ = memory.has_failed ? grid_.ticks() - position_ % grid_.ticks() : longest_span();
    return true;
}

}  // namespace gxrod
