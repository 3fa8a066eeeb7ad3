#pragma once

#include <vector>

#include "state/bed_contact.hpp"
#include "state/contact_memory.hpp"
#include "state/contact_trial.hpp"
#include "state/joint_state.hpp"
#include "state/motion.hpp"

namespace gxrod {

// What a section of a rod remembers between steps at one of its force points (Simo & Vu-Quoc 1986).
struct SectionHistory {
    Quat Lambda;  // section axes at the last accepted step
    Vec3 K;       // curvature Λᵀ Λ′ (material, total) at the last accepted step
};

// Rates of a node at one stage of a Runge-Kutta step.
struct StageRates {
    Vec3 v = Vec3::Zero();
    Vec3 a = Vec3::Zero();
    Vec3 alpha = Vec3::Zero();
    Vec3 theta_dot = Vec3::Zero();                             // of the rotation vector of the step
    Eigen::Vector4d quaternion_dot = Eigen::Vector4d::Zero();  // (x, y, z, w)
};

// What a scheme carries from step to step: generalized-α its algorithmic accelerations, schemes with coupled
// stages the coefficients by which accelerations go on (docs/theory/newmark.md, (R7)).
struct CarriedAcceleration {
    Vec3 a = Vec3::Zero();
    Vec3 alpha = Vec3::Zero();
};

// What evolves. Copying it is all that is needed to come back to it; a step that is not to be committed needs
// less, see undo_trial.
struct State {
    double time = 0.0;                     // of `previous`
    double trial_time = 0.0;               // of `trial`
    std::vector<NodeMotion> previous;      // per node, at the last accepted step
    std::vector<NodeMotion> trial;         // per node, where equilibrium is asked
    std::vector<SectionHistory> sections;  // per force point, in element order
    // Per force point with a law, then the tensions of tendons with friction; of `previous`.
    std::vector<double> law_memory;
    std::vector<BedContact> bed_contacts;                   // per piece that can touch, of `previous`
    ContactMemory contact_memory;                           // of `previous`
    std::vector<JointState> joints_previous, joints_trial;  // per joint
    // Resultants (N, M) per force point, material, that the mixed tangent is made of; empty with any other.
    std::vector<Vec6> resultants;
    ContactTrial contact;
    // Integrator::carried_count() per node, one node after the other.
    std::vector<CarriedAcceleration> carried_previous, carried_trial;
    std::vector<std::vector<StageRates>> stages;  // [stage][node]; Runge-Kutta schemes only
    // [stage][node] and [stage][joint]; schemes whose stages are found together only. In their turn they are
    // the trial.
    std::vector<std::vector<NodeMotion>> stage_motions;
    std::vector<std::vector<JointState>> stage_joints;
};

// Returns to the last accepted step: between commits nothing changes but the trial values, and the rates of
// stages, which every step finds again.
inline void undo_trial(State& state) {
    state.trial = state.previous;
    state.trial_time = state.time;
    state.joints_trial = state.joints_previous;
    state.carried_trial = state.carried_previous;
    state.resultants.clear();
    state.contact = {};
}

}  // namespace gxrod
