#pragma once

#include <array>

#include "rotation/types.hpp"

namespace gxrod {

// What a piece of rod is made from: its nodes, at the Gauss-Lobatto points, with position and section axes at
// t = 0; and the strains (Γ, K) that it has there at its force points, zero of one that is free of stress.
template <int Nodes>
struct RodElementGeometry {
    std::array<int, Nodes> nodes;
    std::array<Vec3, Nodes> positions;
    std::array<Quat, Nodes> triads;
    std::array<Vec6, Nodes - 1> strains = make_zeros();

    static std::array<Vec6, Nodes - 1> make_zeros() {
        std::array<Vec6, Nodes - 1> zeros;
        zeros.fill(Vec6::Zero());
        return zeros;
    }
};

}  // namespace gxrod
