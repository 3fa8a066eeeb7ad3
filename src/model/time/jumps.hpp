#pragma once

#include <vector>

#include "model/model.hpp"
#include "model/time/breaks.hpp"

namespace gxrod {

// Times inside an interval at which something that acts on a model, or within it, jumps: sorted, each once.
// `samples` as find_breaks_in_time has it. Along rods functions are asked at a few places, and those whose
// jumps travel along a rod are left out. Throws EvaluationError.
std::vector<double> find_jumps(const Model& model, const Interval& times, int samples);

// The last time before a jump, and the first after it, by which functions of time are on either side.
struct JumpSides {
    double before, after;
};
JumpSides sides_of_jump(double time, const Interval& times);

}  // namespace gxrod
