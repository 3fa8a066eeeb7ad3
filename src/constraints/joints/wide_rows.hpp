#pragma once

#include <Eigen/Core>
#include <string>
#include <vector>

#include "constraints/step_differences.hpp"
#include "state/constraint_level.hpp"
#include "state/joint_state.hpp"
#include "state/state.hpp"
#include "state/values/joint_values.hpp"

namespace gxrod {

// The arguments of equations over several nodes: motions of all nodes, and the accepted state before.
struct WidePlace {
    const std::vector<NodeMotion>& nodes;  // motions of the whole model; trial motions, or others
    const State& state;                    // with its previous motions and joints_previous of all joints
    const JointState& before;              // state of these equations at the last accepted step
    JointSlips slips_before;               // likewise
    double time;
    double held = 0.0;  // size of the force that the equations hold, for friction that follows it
};

// Up to six equations Φ = 0 that couple several nodes, each with a multiplier λ: they exert Gᵀλ on the nodes,
// G = ∂Φ/∂(δr, δφ). The coupled nodes may change from one evaluation to the next. Matrices have six columns,
// or rows, (δr, δφ), for each node of `list_nodes`, in its order; all are spatial. Like a joint between two
// nodes (JointRows), they do not depend on Δt, β or γ. WideAssembly does scaling, multipliers and assembly.
class WideRows {
  public:
    virtual ~WideRows() = default;

    // The name in messages: "gear stage".
    virtual const std::string& name() const = 0;
    virtual int count() const = 0;
    // Whether a row is a length, so that its multiplier is a force; otherwise it is a turn, with a moment.
    virtual bool is_length(int row) const = 0;
    // Lists the groups of nodes that can be coupled: any list of nodes is part of one group. At least one
    // node is in all groups; the multipliers are counted behind its unknowns.
    virtual std::vector<std::vector<int>> list_groups() const = 0;
    // Lists the nodes that the equations couple at this place, each once, without the ground.
    virtual std::vector<int> list_nodes(const WidePlace& place) const = 0;

    // Computes Φ, Φ̇ or Φ̈, less the motions that motors prescribe, which are differentiated within the step.
    virtual Eigen::VectorXd compute_values(const WidePlace& place,
                                           ConstraintLevel level,
                                           const TimeSpan& step) const = 0;
    // Whether the equations hold at this place. One-sided equations (Φ ≥ 0, λ ≥ 0, Φ λ = 0) open if λ < r Φ,
    // r any positive number: then λ = 0 replaces Φ = 0, and they exert no force.
    virtual bool hold(const WidePlace& /*place*/,
                      const Eigen::VectorXd& /*multipliers*/,
                      ConstraintLevel /*level*/) const {
        return true;
    }
    // Computes G.
    virtual Eigen::MatrixXd compute_gradient(const WidePlace& place) const = 0;
    // Computes ∂Φ̈/∂(Newton's unknowns), by placement, rate and acceleration; linearizations of all nodes.
    virtual Eigen::MatrixXd compute_acceleration_derivative(
        const WidePlace& place, const std::vector<NodeLinearization>& linearizations) const = 0;
    // Computes Gᵀλ.
    virtual Eigen::VectorXd compute_force(const WidePlace& place, const Eigen::VectorXd& multipliers) const {
        return compute_gradient(place).transpose() * multipliers;
    }
    // Computes ∂(Gᵀλ)/∂(δr, δφ).
    virtual Eigen::MatrixXd compute_force_derivative(const WidePlace& place,
                                                     const Eigen::VectorXd& multipliers) const = 0;
    // Computes the part of Gᵀλ, and of the forces of laws, that the ground exerts on the nodes; empty if it
    // is 0.
    virtual Eigen::VectorXd compute_ground_force(const WidePlace& /*place*/,
                                                 const Eigen::VectorXd& /*multipliers*/) const {
        return {};
    }

    // Whether forces act on coordinates that the equations leave free: springs, dampers, drives, friction.
    virtual bool has_laws() const { return false; }
    // Computes the force of these laws on the nodes.
    virtual Eigen::VectorXd compute_law_force(const WidePlace& /*place*/) const { return {}; }
    // Computes the derivative of this force by Newton's unknowns.
    virtual Eigen::MatrixXd compute_law_tangent(
        const WidePlace& /*place*/, const std::vector<NodeLinearization>& /*linearizations*/) const {
        return {};
    }
    // The number of rows, the first ones, whose multipliers are the force that friction follows; 0 if none
    // does.
    virtual int held_rows() const { return 0; }
    // Computes the derivative of the force of laws on the nodes by the size of that force.
    virtual Eigen::VectorXd compute_held_derivative(const WidePlace& /*place*/) const { return {}; }
    // Computes the energy of springs, limits and sticking friction.
    virtual double compute_strain_energy(const WidePlace& /*place*/) const { return 0.0; }
    virtual bool is_damped() const { return false; }
    virtual double compute_damping_power(const WidePlace& /*place*/) const { return 0.0; }
    // Computes the dissipation of dampers from the previous motions to these in a unit of time.
    virtual double compute_damping_action(const WidePlace& /*place*/) const { return 0.0; }
    // Computes the dissipation of friction since the last accepted step.
    virtual double compute_slip_dissipation(const WidePlace& /*place*/) const { return 0.0; }

    // External driving: forces that do work, the coordinates that they move, and their power, in the order of
    // JointAssembly: motors and drives on turn and slide, forces that move the rest of springs of turn and
    // slide, 0, 0.
    virtual bool is_driven() const { return false; }
    virtual Vec6 compute_driving_forces(const WidePlace& /*place*/,
                                        const Eigen::VectorXd& /*multipliers*/) const {
        return Vec6::Zero();
    }
    virtual Vec6 compute_coordinates(const WidePlace& /*place*/) const { return Vec6::Zero(); }
    virtual double compute_driving_power(const WidePlace& /*place*/,
                                         const Eigen::VectorXd& /*multipliers*/,
                                         const TimeSpan& /*step*/) const {
        return 0.0;
    }

    // Computes the values that a history records; the assembly sets their gap.
    virtual JointValues compute_joint_values(const WidePlace& place,
                                             const Eigen::VectorXd& multipliers) const = 0;

    // Throws EvaluationError, which names these equations, at motions for which they have no meaning.
    virtual void check_range(const WidePlace& /*place*/) const {}

    // Returns the slide at which friction is zero at the start of a run.
    virtual double find_first_slip(const WidePlace& /*place*/) const { return 0.0; }
    // Sets the values kept from step to step when a step is accepted; returns the slide at which friction is
    // zero then.
    virtual double commit(const WidePlace& /*place*/, JointState& /*state*/) const { return 0.0; }
};

}  // namespace gxrod
