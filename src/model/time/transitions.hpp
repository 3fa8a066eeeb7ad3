#pragma once

#include <vector>

#include "model/time/breaks.hpp"
#include "model/time/time_function.hpp"

namespace gxrod {

// Where a function of time jumps or has a kink: its values and slopes on both sides.
struct Transition {
    double time = 0.0;
    double value_before = 0.0;
    double value_after = 0.0;
    double slope_before = 0.0;
    double slope_after = 0.0;
    bool is_jump = false;
    bool is_kink = false;  // never of a jump
};

// Those from the start of the interval to its end, by the function's switches; `samples` as
// find_breaks_in_time has it. At the start the value counts that it has there, and no slope before it is
// looked for. What is round-off, and kinks of less than 1e-3 of the largest slope, is left out. Throws
// EvaluationError.
std::vector<Transition> find_transitions(const TimeFunction& function, const Interval& times, int samples);

}  // namespace gxrod
