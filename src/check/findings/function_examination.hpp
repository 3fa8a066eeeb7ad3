#pragma once

#include <vector>

#include "check/model_examination.hpp"
#include "model/model.hpp"
#include "model/settings/settings.hpp"

namespace gxrod {

// What is suspicious in how loads and moves change with time in a dynamic analysis: pulses that the steps
// miss and moves whose velocity jumps (warnings), and moves that set rods at rest in motion at once (notes).
std::vector<Finding> examine_functions(const Model& model,
                                       const DynamicSettings& settings,
                                       bool is_moving = false);

}  // namespace gxrod
