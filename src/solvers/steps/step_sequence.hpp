#pragma once

#include <memory>
#include <optional>

#include "model/settings/settings.hpp"
#include "state/step_memory.hpp"

namespace gxrod {

// The steps of an analysis: chooses the end of the next one from the course of the last ones.
class StepSequence {
  public:
    virtual ~StepSequence() = default;

    // Returns the time at the end of the last accepted step.
    virtual double time() const = 0;
    // Return the exact end and the length of the next step to try.
    virtual double next_time() const = 0;
    virtual double time_step() const = 0;
    virtual bool finished() const = 0;

    // Return whether steps are chosen by their error, and if so, whether the step that was just solved may be
    // accepted with this estimate.
    virtual bool needs_error() const { return false; }
    virtual bool admits(double /*error*/) { return true; }
    // Makes one step end at this time; later steps continue as before. Returns the exact time, which may
    // differ by rounding: a time at which steps end anyway, or the accepted time. nullopt if it is before
    // that or after the end, or if steps are not in time.
    virtual std::optional<double> land_on(double /*time*/) { return std::nullopt; }
    // Notes that the step was accepted.
    virtual void accept() = 0;
    // Notes that the step failed or was rejected: the next one is shorter. Returns false if it is already the
    // shortest.
    virtual bool reject() = 0;

    // Return the progress for a reader: steps done, steps in all (0: not known in advance), and the part
    // done, 0 … 1.
    virtual long steps_done() const = 0;
    virtual long steps_in_all() const = 0;
    virtual double part_done() const = 0;
    // Returns whether a frame is due at the accepted time if one is due every so many steps.
    virtual bool is_frame_due(long every) const = 0;

    // Store and restore the accepted time, to resume with a sequence of the same or other settings. Restoring
    // returns false if these steps cannot meet that time, or it is past the end.
    virtual StepMemory memory() const = 0;
    virtual bool resume(const StepMemory& memory) = 0;
};

// Makes equal steps, or steps by their error if the settings have `adaptive`.
std::unique_ptr<StepSequence> make_step_sequence(const DynamicSettings& settings);

}  // namespace gxrod
