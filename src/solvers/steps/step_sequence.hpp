#pragma once

#include <memory>
#include <optional>

#include "model/settings/settings.hpp"
#include "state/step_memory.hpp"

namespace gxrod {

// The steps of an analysis: where the next one ends, and what follows from how it went.
class StepSequence {
  public:
    virtual ~StepSequence() = default;

    // Of the last accepted step's end.
    virtual double time() const = 0;
    // Of the step to try next: where it ends, to the last bit, and its length.
    virtual double next_time() const = 0;
    virtual double time_step() const = 0;
    virtual bool finished() const = 0;

    // Whether steps are chosen by their error; then, whether the step that was just solved may be accepted
    // with this estimate of it.
    virtual bool needs_error() const { return false; }
    virtual bool admits(double /*error*/) { return true; }
    // Has a step end at this time, once; steps go on from there as before. The time that it will be, which is
    // this one but for rounding: one at which steps end anyway, or the accepted time. nullopt if it is before
    // that or after the end, or steps are not of time.
    virtual std::optional<double> land_on(double /*time*/) { return std::nullopt; }
    // The step was accepted.
    virtual void accept() = 0;
    // The step failed, or was not admitted: a shorter one comes next. False if it is already as short as it
    // may be.
    virtual bool reject() = 0;

    // Progress for a reader: steps done, of how many (0: not known beforehand), and the part of the whole
    // done, 0 … 1.
    virtual long steps_done() const = 0;
    virtual long steps_in_all() const = 0;
    virtual double part_done() const = 0;
    // Whether a frame is due at the accepted time when one is due every so many steps.
    virtual bool is_frame_due(long every) const = 0;

    // To resume later from the accepted time, with a sequence of the same settings or of others. False if
    // that time is not one that these steps can meet, or is past the end.
    virtual StepMemory memory() const = 0;
    virtual bool resume(const StepMemory& memory) = 0;
};

// Equal steps, or steps by their error if the settings have `adaptive`.
std::unique_ptr<StepSequence> make_step_sequence(const DynamicSettings& settings);

}  // namespace gxrod
