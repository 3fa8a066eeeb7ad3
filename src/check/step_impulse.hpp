#pragma once

#include <functional>
#include <optional>
#include <vector>

#include "integrators/integrator.hpp"

// The impulse of loads that time steps miss.
namespace gxrod {

// A load that changes with time, and its jumps and kinks between 0 and the end of the steps.
struct TimedLoad {
    std::function<double(double)> value;
    std::vector<double> breaks;  // sorted
};

struct StepTimes {
    double end_time = 0.0;
    double time_step = 0.0;
};

// An impulse that steps integrate wrongly.
struct LostImpulse {
    double from = 0.0;  // start and end of the interval in which it is wrong
    double to = 0.0;
    double given = 0.0;  // by the steps
    double exact = 0.0;
    double step_needed = 0.0;  // a step that resolves it
};

// Finds the worst interval in which the error exceeds 0.3 of the load's impulse above a straight line: near
// breaks over five steps to both sides; elsewhere over eight steps of some hundred in all. A load that is
// switched on or off once is therefore not reported, wherever in a step that happens: it comes at most half a
// step too early or too late.
std::optional<LostImpulse> find_lost_impulse(const TimedLoad& load,
                                             const StepTimes& times,
                                             const Integrator& integrator);

}  // namespace gxrod
