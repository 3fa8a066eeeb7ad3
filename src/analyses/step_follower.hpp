#pragma once

#include "state/records/step_record.hpp"

namespace gxrod {

// Follows the motion within a step and acts on it. The step is found again until both fit.
class StepFollower {
  public:
    virtual ~StepFollower() = default;
    // Before a trial of a step between these times of the stage.
    virtual void begin(double from, double to) = 0;
    // Takes the trial's end. Returns whether the step has to be found again, by what it has set now.
    virtual bool follow(const Snapshot& trial, double time) = 0;
};

}  // namespace gxrod
