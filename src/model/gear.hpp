#pragma once

#include <array>
#include <optional>
#include <string>

#include "model/joint.hpp"

namespace gxrod {

// A coordinate that a joint leaves free.
struct GearSide {
    int joint = 0;        // index in Model::joints
    bool is_turn = true;  // otherwise the slide
};

// Couples the coordinates of two joints: ratio × first + second = 0, both since t = 0. Teeth that yield, or
// have play, push where the sum is beyond their bounds.
struct Gear {
    std::string name;
    std::array<GearSide, 2> sides{};
    double ratio = 1.0;
    std::optional<CoordinateLimits> teeth = {};  // nullopt: the sum is 0
};

}  // namespace gxrod
