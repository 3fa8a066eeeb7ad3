#pragma once

#include <vector>

#include "state/contact_trial.hpp"
#include "state/joint_state.hpp"
#include "state/motion.hpp"
#include "state/pair_traction.hpp"

namespace gxrod {

// Memory of a section of a rod at a force point between steps (Simo & Vu-Quoc 1986).
struct SectionHistory {
    Quat Lambda;  // section axes at the last accepted step
    Vec3 K;       // curvature Λᵀ Λ′ (material, total) at the last accepted step
};

// Rates of a node at one stage of a Runge-Kutta step.
struct StageRates {
    Vec3 v = Vec3::Zero();
    Vec3 a = Vec3::Zero();
    Vec3 alpha = Vec3::Zero();
    Vec3 theta_dot = Vec3::Zero();                             // rate of the rotation vector of the step
    Eigen::Vector4d quaternion_dot = Eigen::Vector4d::Zero();  // (x, y, z, w)
};

// Accelerations that a scheme carries from step to step: the algorithmic ones for generalized-α, the
// coefficients that extrapolate accelerations for schemes with coupled stages (docs/theory/newmark.md, (R7)).
struct CarriedAcceleration {
    Vec3 a = Vec3::Zero();
    Vec3 alpha = Vec3::Zero();
};

// All variables that evolve. A copy is enough to come back to this state; to drop a step that is not
// committed, undo_trial is enough.
struct State {
    double time = 0.0;                     // time of `previous`
    double trial_time = 0.0;               // time of `trial`
    std::vector<NodeMotion> previous;      // per node, at the last accepted step
    std::vector<NodeMotion> trial;         // per node, where equilibrium is sought
    std::vector<SectionHistory> sections;  // per force point, in element order
    // All other numbers that parts remember from step to step, at `previous`; each part of the system has a
    // slice (MemorySlice). Only a commit changes them.
    std::vector<double> memory;
    std::vector<PairTraction> pair_tractions;               // friction between rods at `previous`, sorted
    std::vector<JointState> joints_previous, joints_trial;  // per joint
    // Resultants (N, M) per force point, material, from which the mixed tangent is computed; empty with other
    // tangents.
    std::vector<Vec6> resultants;
    ContactTrial contact;
    // Integrator::carried_count() entries per node, one node after the other.
    std::vector<CarriedAcceleration> carried_previous, carried_trial;
    std::vector<std::vector<StageRates>> stages;  // [stage][node]; Runge-Kutta schemes only
    // [stage][node] and [stage][joint], only for schemes whose stages are found together. Each stage becomes
    // the trial in turn.
    std::vector<std::vector<NodeMotion>> stage_motions;
    std::vector<std::vector<JointState>> stage_joints;
};

// Takes over the last accepted step of another system of the same parts.
inline void take_over(const State& from, State& to) {
    to.previous = to.trial = from.previous;
    to.sections = from.sections;
    to.memory = from.memory;
    to.pair_tractions = from.pair_tractions;
    to.joints_previous = to.joints_trial = from.joints_previous;
}

// Returns to the last accepted step. Between commits only the trial values change, and the rates of stages,
// which every step finds again.
inline void undo_trial(State& state) {
    state.trial = state.previous;
    state.trial_time = state.time;
    state.joints_trial = state.joints_previous;
    state.carried_trial = state.carried_previous;
    state.resultants.clear();
    state.contact = {};
}

}  // namespace gxrod
