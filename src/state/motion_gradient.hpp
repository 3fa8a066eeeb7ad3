#pragma once

#include <vector>

#include "state/state.hpp"

namespace gxrod {

// How a scalar changes with the motions of all nodes and with what a scheme carries: a factor of each number.
// Rotations change by spins: Λ ← exp(δφ) Λ.
struct MotionGradient {
    struct OfNode {
        Vec3 r = Vec3::Zero(), phi = Vec3::Zero();
        Vec3 v = Vec3::Zero(), omega = Vec3::Zero();
        Vec3 a = Vec3::Zero(), alpha = Vec3::Zero();
    };

    std::vector<OfNode> nodes;
    std::vector<CarriedAcceleration> carried;  // as State::carried_previous

    MotionGradient() = default;
    explicit MotionGradient(const State& state)
        : nodes(state.previous.size()), carried(state.carried_previous.size()) {}
};

}  // namespace gxrod
