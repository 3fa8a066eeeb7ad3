#pragma once

#include <array>

#include "rotation/types.hpp"

namespace gxrod {

// A place where a rod touches an obstacle or another rod, with the forces there.
struct ContactTouch {
    std::array<int, 2> rods{};           // by index; −1 − j is obstacle j, always second
    std::array<double, 2> places{};      // fractions of their lengths; 0 for an obstacle
    Vec3 point = Vec3::Zero();           // halfway between both surfaces
    Vec3 normal_force = Vec3::Zero();    // on the first rod
    Vec3 friction_force = Vec3::Zero();  // likewise
    double gap = 0.0;
    bool slides = false;
};

}  // namespace gxrod
