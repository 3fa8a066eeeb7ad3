#pragma once

#include <array>
#include <string>

namespace gxrod {

// An overlap of a rod or body with an obstacle, or of two rods, at its deepest place.
struct ContactOverlap {
    std::array<int, 2> rods{};          // as in ContactTouch
    std::array<double, 2> places{};     // fractions of their lengths
    double gap = 0.0;                   // ≤ 0; −∞ where its line crosses a triangle
    double radii = 0.0;                 // for two rods: the sum of their radii
    std::string triangle{};             // "triangle 7 of " for an obstacle that is a mesh
    std::array<int, 2> shapes{-1, -1};  // of bodies, in Contact::bodies
};

}  // namespace gxrod
