#pragma once

#include <vector>

#include "model/time/breaks.hpp"
#include "model/time/time_function.hpp"

namespace gxrod {

// A jump or kink of a function of time: its values and slopes on both sides.
struct Transition {
    double time = 0.0;
    double value_before = 0.0;
    double value_after = 0.0;
    double slope_before = 0.0;
    double slope_after = 0.0;
    bool is_jump = false;
    bool is_kink = false;  // false for a jump
};

// Finds the transitions from the start of the interval to its end, by the function's switches; `samples` is
// the same as in find_breaks_in_time. At the start it takes the value there, and no slope before it.
// Round-off, and kinks of less than 1e-3 of the largest slope, are left out. Throws EvaluationError.
std::vector<Transition> find_transitions(const TimeFunction& function, const Interval& times, int samples);

}  // namespace gxrod
