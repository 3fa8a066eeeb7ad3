#include "solvers/steps/step_control.hpp"

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

void StepControl::go_to(double time) {
    const StepGrid::Place place = grid_.find(time);
    position_ = place.position;
    off_grid_.reset();
    if (place.is_exact) {
        span_ = longest_span();
        return;
    }
    if (at(position_) > time) --position_;
    off_grid_ = time;
    span_ = grid_.ticks() - position_ % grid_.ticks();
    if (position_ + span_ < end_ && at(position_ + span_) - time < sliver()) span_ += grid_.ticks();
}

std::optional<double> StepControl::land_on(double time) {
    const StepGrid::Place place = grid_.find(time);
    const double wanted = place.is_exact && place.position <= end_ ? at(place.position) : time;
    if (wanted < this->time() || wanted > end_time_) return std::nullopt;
    landing_.reset();
    // Steps that are not cut end at nominal times anyway.
    const bool is_nominal = place.is_exact && place.position % grid_.ticks() == 0 && at_nominal_step();
    if (!is_nominal && wanted > this->time()) landing_ = wanted;
    return wanted;
}

void StepControl::accept() {
    if (lands_next()) {
        const double reached = *landing_;
        landing_.reset();
        go_to(reached);
        return;
    }
    position_ += span_;
    off_grid_.reset();
    span_ = longest_span();
}

bool StepControl::reject() {
    const double failed = next_time();
    while (span_ > 1 && next_time() >= failed) span_ /= 2;
    has_failed_ = next_time() >= failed;
    return !has_failed_;
}

StepMemory StepControl::memory() const {
    StepMemory memory;
    memory.time = time();
    memory.has_failed = has_failed_;
    memory.is_off_grid = off_grid_.has_value();
    return memory;
}

// The next step is the longest that fits the grid, as after any accepted one; but where the shortest one
// failed, a whole one to the next nominal time is tried: settings can have changed.
bool StepControl::resume(const StepMemory& memory) {
    const StepGrid::Place place = grid_.find(memory.time);
    landing_.reset();
    if (memory.is_off_grid && memory.time < end_time_) {
        go_to(memory.time);
        return true;
    }
    if (!place.is_exact || place.position > end_) return false;
    off_grid_.reset();
    position_ = place.position;
    span_ = memory.has_failed ? grid_.ticks() - position_ % grid_.ticks() : longest_span();
    return true;
}

}  // namespace gxrod
