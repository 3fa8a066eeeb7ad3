#pragma once

#include <vector>

#include "check/model_examination.hpp"
#include "model/model.hpp"
#include "model/settings/settings.hpp"

namespace gxrod {

// Finds suspicious changes of loads and moves in a dynamic analysis: pulses that the steps miss and moves
// whose velocity jumps (warnings), and moves that suddenly set resting rods in motion (notes).
std::vector<Finding> examine_functions(const Model& model,
                                       const DynamicSettings& settings,
                                       bool is_moving = false);

}  // namespace gxrod
