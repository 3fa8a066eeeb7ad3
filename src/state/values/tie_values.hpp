#pragma once

#include <vector>

#include "state/values/bushing_values.hpp"
#include "state/values/spring_values.hpp"

namespace gxrod {

// Values of the ties that are elements, at a step; each list in the order of the model's.
struct TieValues {
    std::vector<SpringValues> springs;
    std::vector<BushingValues> bushings;
};

}  // namespace gxrod
