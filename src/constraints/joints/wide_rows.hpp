#pragma once

#include <Eigen/Core>
#include <string>
#include <vector>

#include "constraints/step_differences.hpp"
#include "state/constraint_level.hpp"
#include "state/state.hpp"
#include "state/values/joint_values.hpp"

namespace gxrod {

// Where equations over several nodes are evaluated: motions of all nodes, and what was accepted before.
struct WidePlace {
    const std::vector<NodeMotion>& nodes;  // of the whole model; trial motions, or others
    const State& state;                    // its previous motions, and its joints_previous of all joints
    const JointState& before;              // of these equations, at the last accepted step
    double time;
};

// Equations Φ = 0 that couple several nodes, with a multiplier λ each, up to six: they exert Gᵀλ on the
// nodes, G = ∂Φ/∂(δr, δφ). Which nodes they couple may change from one evaluation to the next. Matrices have
// six columns, or rows, (δr, δφ), for each node of `list_nodes`, in its order; all is spatial. Like a joint
// between two nodes (JointRows), they never see Δt, β or γ. Scaling, multipliers and where it all goes are
// the business of WideAssembly.
class WideRows {
  public:
    virtual ~WideRows() = default;

    // As messages have it: "gear stage".
    virtual const std::string& name() const = 0;
    virtual int count() const = 0;
    // Whether a row is a length, so that its multiplier is a force; otherwise a turn, with a moment.
    virtual bool is_length(int row) const = 0;
    // The groups of nodes that are ever coupled: any list of nodes is part of one group. At least one node,
    // whose unknowns the multipliers are counted behind, is in all groups.
    virtual std::vector<std::vector<int>> list_groups() const = 0;
    // Those that the equations couple at this place, each once; not the ground.
    virtual std::vector<int> list_nodes(const WidePlace& place) const = 0;

    // Φ, Φ̇ or Φ̈, what motors prescribe taken off; motors are differentiated within the step.
    virtual Eigen::VectorXd compute_values(const WidePlace& place,
                                           ConstraintLevel level,
                                           const TimeSpan& step) const = 0;
    // Whether the equations hold at this place. One-sided ones (Φ ≥ 0, λ ≥ 0, Φ λ = 0) let go where λ < r Φ,
    // r any positive number: there λ = 0 takes the place of Φ = 0, and they exert nothing.
    virtual bool hold(const WidePlace& /*place*/,
                      const Eigen::VectorXd& /*multipliers*/,
                      ConstraintLevel /*level*/) const {
        return true;
    }
    // G.
    virtual Eigen::MatrixXd compute_gradient(const WidePlace& place) const = 0;
    // ∂Φ̈/∂(Newton's unknowns), by placement, rate and acceleration; linearizations of all nodes.
    virtual Eigen::MatrixXd compute_acceleration_derivative(
        const WidePlace& place, const std::vector<NodeLinearization>& linearizations) const = 0;
    // Gᵀλ.
    virtual Eigen::VectorXd compute_force(const WidePlace& place, const Eigen::VectorXd& multipliers) const {
        return compute_gradient(place).transpose() * multipliers;
    }
    // ∂(Gᵀλ)/∂(δr, δφ).
    virtual Eigen::MatrixXd compute_force_derivative(const WidePlace& place,
                                                     const Eigen::VectorXd& multipliers) const = 0;
    // The part of Gᵀλ, and of the forces of laws, that the ground exerts on the nodes; empty if it is 0.
    virtual Eigen::VectorXd compute_ground_force(const WidePlace& /*place*/,
                                                 const Eigen::VectorXd& /*multipliers*/) const {
        return {};
    }

    // What acts on coordinates that the equations leave free: springs, dampers, drives, friction.
    virtual bool has_laws() const { return false; }
    // On the nodes.
    virtual Eigen::VectorXd compute_law_force(const WidePlace& /*place*/) const { return {}; }
    // The derivative of this force by Newton's unknowns.
    virtual Eigen::MatrixXd compute_law_tangent(
        const WidePlace& /*place*/, const std::vector<NodeLinearization>& /*linearizations*/) const {
        return {};
    }
    // Of springs, limits and friction that sticks.
    virtual double compute_strain_energy(const WidePlace& /*place*/) const { return 0.0; }
    virtual bool is_damped() const { return false; }
    virtual double compute_damping_power(const WidePlace& /*place*/) const { return 0.0; }
    // What dampers would take from the previous motions to these in a unit of time.
    virtual double compute_damping_action(const WidePlace& /*place*/) const { return 0.0; }
    // What friction takes from the last accepted step to here.
    virtual double compute_slip_dissipation(const WidePlace& /*place*/) const { return 0.0; }

    // What does work from outside, what these forces move, and their power, as JointAssembly gives them:
    // motors and drives on turn and slide, what moves the rest of springs of turn and slide, 0, 0.
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

    // What a history records; its gap is set by the assembly.
    virtual JointValues compute_joint_values(const WidePlace& place,
                                             const Eigen::VectorXd& multipliers) const = 0;

    // Throws EvaluationError, which names these equations, where they have no meaning any more.
    virtual void check_range(const WidePlace& /*place*/) const {}

    // What is kept from step to step, but for the multipliers: at the start of a run, and when a step is
    // accepted.
    virtual void start(const WidePlace& /*place*/, JointState& /*state*/) const {}
    virtual void commit(const WidePlace& /*place*/, JointState& /*state*/) const {}
};

}  // namespace gxrod
