#pragma once

#include <vector>

#include "state/state.hpp"

namespace gxrod {

// The derivative of an accepted state by a number, for all that State keeps from step to step. Rotations
// change by spins: Λ ← exp(δφ) Λ.
struct StateDirection {
    struct OfNode {
        Vec3 r = Vec3::Zero(), phi = Vec3::Zero();
        Vec3 v = Vec3::Zero(), omega = Vec3::Zero();
        Vec3 a = Vec3::Zero(), alpha = Vec3::Zero();
    };
    struct OfSection {
        Vec3 phi = Vec3::Zero(), K = Vec3::Zero();
    };

    std::vector<OfNode> nodes;
    std::vector<OfSection> sections;
    std::vector<double> memory;
    std::vector<CarriedAcceleration> carried;
    std::vector<JointState> joints;
};

// Moves the accepted state along a direction by `amount`.
void move_along(const StateDirection& direction, double amount, State& state);

// Computes (up − down)/(2 step) from accepted states. Rotations of nodes are compared with those of `centre`,
// if given: what both sides add to their spins from there then drops out, and with it all of even order.
StateDirection differentiate(const State& up, const State& down, double step, const State* centre = nullptr);
// Computes (4 near − far)/3, extrapolated from the differences with a step and with twice the step.
StateDirection extrapolate(StateDirection near, const StateDirection& far);

}  // namespace gxrod
