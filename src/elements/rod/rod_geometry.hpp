#pragma once

#include <array>
#include <optional>

#include "rotation/types.hpp"

namespace gxrod {

// The geometry of a rod element: its nodes, at the Gauss-Lobatto points, with position and section axes at t
// = 0; and either its strains (Γ, K) at the force points at t = 0, zero if it is free of stress, or its
// stress-free shape.
template <int Nodes>
struct RodElementGeometry {
    std::array<int, Nodes> nodes;
    std::array<Vec3, Nodes> positions;
    std::array<Quat, Nodes> triads;
    std::array<Vec6, Nodes - 1> strains = make_zeros();
    struct Shape {
        std::array<Vec3, Nodes> positions;
        std::array<Quat, Nodes> triads;
    };
    std::optional<Shape> rest = {};

    // The shape by which lengths are measured: the stress-free shape, or the shape at t = 0.
    RodElementGeometry reference() const {
        RodElementGeometry made = *this;
        if (!rest) return made;
        made.positions = rest->positions;
        made.triads = rest->triads;
        return made;
    }

    static std::array<Vec6, Nodes - 1> make_zeros() {
        std::array<Vec6, Nodes - 1> zeros;
        zeros.fill(Vec6::Zero());
        return zeros;
    }
};

}  // namespace gxrod
