#pragma once

#include <array>
#include <vector>

#include "constraints/step_differences.hpp"
#include "model/model.hpp"
#include "state/state.hpp"

namespace gxrod {

// Which of a node's components x y z rx ry rz a support holds, in the support's own axes.
using HeldComponents = std::array<bool, 6>;

// What supports forbid, and where those that move take their nodes. A held spin keeps the rotation about its
// axis: with all three held the rotation is fixed or prescribed, with two the node is hinged about the third.
class Supports {
  public:
    // The model must outlive it.
    explicit Supports(const Model& model);

    std::size_t node_count() const { return held_.size(); }
    const HeldComponents& held(int node) const { return held_[node]; }
    // The axes, as columns, in which a node's unknowns are counted: its support's, or the global ones.
    bool has_own_axes(int node) const { return own_axes_[node] >= 0; }
    const Mat3& axes(int node) const { return axes_[own_axes_[node] + 1]; }

    // Whether any component moves.
    bool move() const { return !moving_.empty(); }
    // The supports that do.
    const std::vector<const Support*>& moving() const { return moving_; }

    // Puts held positions and rotations where the supports want them at `time`; θ counts from
    // state.previous, at state.time, whole turns included.
    void place(double time, State& state) const;
    // Velocities and accelerations of held components at a time within a step: zero where fixed, where they
    // move the derivatives of f, by differences within the step. Those of a node that can still turn about
    // some axis stay what they are: the spins of its held axes depend on how it turns. Without inertia
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
