#pragma once

#include <vector>

#include "model/model.hpp"
#include "model/time/breaks.hpp"

namespace gxrod {

// Finds the times inside an interval at which an action on a model, or within it, jumps: sorted, each once.
// `samples` is the same as in find_breaks_in_time. Functions along rods are evaluated at a few places; jumps
// that travel along a rod are left out. Throws EvaluationError.
std::vector<double> find_jumps(const Model& model, const Interval& times, int samples);

// The last time before a jump, and the first after it, for functions of time on either side.
struct JumpSides {
    double before, after;
};
JumpSides sides_of_jump(double time, const Interval& times);

}  // namespace gxrod
