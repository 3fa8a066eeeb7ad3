#pragma once

#include <string>
#include <vector>

#include "assembly/system.hpp"
#include "model/parts.hpp"

namespace gxrod {

// Names the main strain of a direction, its rod, and the place where the rod moves most: "rod cable, node 14:
// twist". The direction is per node (δr over the model's length, δφ); the part has rods.
std::string describe_straining(const std::vector<Vec6>& direction,
                               const ModelPart& part,
                               const System& system,
                               const State& state);

}  // namespace gxrod
