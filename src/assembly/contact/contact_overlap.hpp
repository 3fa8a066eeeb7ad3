#pragma once

#include <array>
#include <string>

namespace gxrod {

// A rod or body that is in an obstacle, or a rod in another one, where it is deepest.
struct ContactOverlap {
    std::array<int, 2> rods{};       // as ContactTouch has them
    std::array<double, 2> places{};  // fractions of their lengths
    double gap = 0.0;                // ≤ 0; −∞ where its line crosses a triangle
    double radii = 0.0;              // of rods: the sum of theirs
    std::string triangle{};          // "triangle 7 of " where the obstacle is a mesh
};

}  // namespace gxrod
