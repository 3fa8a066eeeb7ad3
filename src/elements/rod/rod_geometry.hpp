#pragma once

#include <array>

#include "rotation/types.hpp"

namespace gxrod {

// What a piece of rod is made from: its nodes, at the Gauss-Lobatto points, with position and section axes at
// t = 0.
template <int Nodes>
struct RodElementGeometry {
    std::array<int, Nodes> nodes;
    std::array<Vec3, Nodes> positions;
    std::array<Quat, Nodes> triads;
};

}  // namespace gxrod
