#pragma once

#include <array>
#include <vector>

#include "constraints/step_differences.hpp"
#include "model/model.hpp"
#include "state/state.hpp"

namespace gxrod {

// The components x y z rx ry rz of a node that a support holds, in the support's own axes.
using HeldComponents = std::array<bool, 6>;

// The held components of all supports, and the prescribed places of those that move. A held spin keeps the
// rotation about its axis: with all three held the rotation is fixed or prescribed, with two the node is
// hinged about the third.
class Supports {
  public:
    // The model must outlive it.
    explicit Supports(const Model& model);

    std::size_t node_count() const { return held_.size(); }
    const HeldComponents& held(int node) const { return held_[node]; }
    // The axes of a node's unknowns, as columns: its support's axes, or the global ones.
    bool has_own_axes(int node) const { return own_axes_[node] >= 0; }
    const Mat3& axes(int node) const { return axes_[own_axes_[node] + 1]; }

    // Whether any support moves.
    bool move() const { return !moving_.empty(); }
    // The supports that move.
    const std::vector<const Support*>& moving() const { return moving_; }

    // Sets held positions and rotations to their prescribed values at `time`; θ counts from state.previous,
    // at state.time, whole turns included.
    void place(double time, State& state) const;
    // Sets velocities and accelerations of held components at a time within a step: zero if fixed, else the
    // derivatives of the prescribed motion f, by differences within the step. Rates of a node that can still
    // turn about some axis stay unchanged: the spins of its held axes depend on its rotation. Without inertia
    // accelerations are 0, as integrators leave them.
    void set_rates(double time, const TimeSpan& step, std::vector<NodeMotion>& motions) const;

  private:
    void place_position(const Support& support, double time, NodeMotion& motion) const;
    void place_rotation(const Support& support, double time, State& state) const;

    const Model* model_;
    std::vector<HeldComponents> held_;
    std::vector<int> own_axes_;
    std::vector<Mat3> axes_{Mat3::Identity()};
    std::vector<const Support*> moving_;
};

}  // namespace gxrod
