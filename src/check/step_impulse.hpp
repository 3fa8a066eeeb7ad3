#pragma once

#include <functional>
#include <optional>
#include <vector>

#include "integrators/integrator.hpp"

// How much of a load's impulse steps of time catch.
namespace gxrod {

// A load that changes with time, and where it jumps or has kinks between 0 and the end of the steps.
struct TimedLoad {
    std::function<double(double)> value;
    std::vector<double> breaks;  // sorted
};

struct StepTimes {
    double end_time = 0.0;
    double time_step = 0.0;
};

// An impulse that steps get wrong.
struct LostImpulse {
    double from = 0.0;  // of the time in which it is wrong
    double to = 0.0;
    double given = 0.0;  // by the steps
    double exact = 0.0;
    double step_needed = 0.0;  // a step that catches it
};

// The worst one, if any is wrong by more than 0.3 of what the load has there above a straight line: near to
// breaks, over five steps to both sides; elsewhere, over eight steps of some hundred in all. So a load that
// is switched on or off once is not reported, wherever in a step that is: it comes at most half a step too
// soon or too late.
std::optional<LostImpulse> find_lost_impulse(const TimedLoad& load,
                                             const StepTimes& times,
                                             const Integrator& integrator);

}  // namespace gxrod
