#pragma once

#include "constraints/joints/joint_frames.hpp"
#include "model/joint.hpp"

namespace gxrod {

// The contact of a pin in a hole, or of a ball in a socket, with clearance, docs/theory/joints.md (J34) to
// (J36): B carries the pin, A the hole. It does not depend on a time step.
class ClearanceForce {
  public:
    // The joint has a clearance.
    explicit ClearanceForce(const Joint& joint);

    bool dissipates() const { return law_.dissipates(); }
    // Computes the distance of the points from each other, across the axis if there is one.
    double compute_distance(const JointMotions& motions) const;
    // Computes forces, and moments about the nodes, on (A, B).
    PairRow compute_force(const JointMotions& motions) const;
    // Computes the derivative of the transposed force by Newton's unknowns.
    PairMatrix compute_tangent(const JointMotions& motions, const JointLinearizations& linearizations) const;
    // Computes the energy that the contact stores, and the power that it dissipates; never negative.
    double compute_energy(const JointMotions& motions) const;
    double compute_damping_power(const JointMotions& motions) const;

  private:
    // Positions and rates by which the contact acts, of numbers of any kind.
    template <class Number>
    struct Place;
    // The force on B and its moment about B's point.
    template <class Number>
    struct Exerted;

    JointFrames frames_of(const JointMotions& motions) const {
        return {motions, arms_, ConstraintLevel::velocity};
    }
    Place<double> find_place(const JointFrames& frames) const;
    template <class Number>
    Exerted<Number> compute_exerted(const Place<Number>& place) const;

    JointArms arms_;
    bool has_axis_;  // otherwise the points are free in all directions
    Vec3 axis_;      // axis of A, in the global axes of t = 0
    JointClearance law_;
};

}  // namespace gxrod
