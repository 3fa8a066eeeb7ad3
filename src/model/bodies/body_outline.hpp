#pragma once

#include <array>
#include <string>
#include <vector>

#include "rotation/types.hpp"

namespace gxrod {

// Holds what a body looks like in pictures: triangles and lines that move with it. No force depends on it.
struct BodyOutline {
    int body = 0;
    bool is_given = false;       // by the deck; otherwise it follows from mass, inertia, contact and joints
    std::vector<Vec3> points{};  // corners, from the body's node, body axes
    std::vector<std::array<int, 3>> triangles{};  // numbers of points, counter-clockwise seen from outside
    std::vector<std::array<int, 2>> lines{};      // edges, and lines without a surface
};

}  // namespace gxrod
