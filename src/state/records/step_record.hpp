#pragma once

#include <cstdint>
#include <span>

#include "state/contact_touch.hpp"
#include "state/state.hpp"
#include "state/values/joint_values.hpp"
#include "state/values/obstacle_values.hpp"
#include "state/values/point_values.hpp"
#include "state/values/section_values.hpp"
#include "state/values/tendon_values.hpp"

// What an analysis hands to the results at an accepted step.
namespace gxrod {

struct LedgerRow {
    double kinetic_energy = 0.0;
    double strain_energy = 0.0;
    double external_work = 0.0;          // of loads, gravity included, since t = 0
    double fluid_work = 0.0;             // the part of it that water, air and the ground do
    double contact_energy = 0.0;         // stored between rods and what they touch
    double contact_loss = 0.0;           // by contact since t = 0: of impacts and of friction
    double work_uncertainty = 0.0;       // of the work of the last load step; 0 in dynamics
    double dissipated_energy = 0.0;      // by material and mass-proportional damping since t = 0
    double numerical_dissipation = 0.0;  // by the scheme itself since t = 0
    // (kinetic + strain + contact) − its value at t = 0 − external work + dissipated + numerical dissipation
    // + contact loss
    double energy_error = 0.0;
    Vec3 linear_momentum = Vec3::Zero();
    Vec3 angular_momentum = Vec3::Zero();  // about the origin
};

struct SolverRow {
    double time_step = 0.0;
    int newton_iterations = 0;  // over all stages of the step
    double residual = 0.0;      // scaled, of the last equilibrium
    int rejected_steps = 0;     // trials cut before this step was accepted
    // Of models with contact: places that touch; the least gap that any iteration came to; iterations whose
    // increment contact has shortened.
    std::int64_t contacts = 0;
    double least_gap = 0.0;
    int shortened = 0;
    // Of the tangent at a static equilibrium: unstable shapes. −1: not known, as where loads have no
    // potential.
    std::int64_t negative_pivots = -1;
};

// The accepted state and what is derived from it. Valid only during the call that passes it.
struct Snapshot {
    double time;  // on the axis that stages share
    std::span<const NodeMotion> nodes;
    // Of all rods, in the order of Model::rods, from start to end; for frames, empty without one.
    std::span<const SectionValues> elements;
    std::span<const Vec6> reactions;  // per node: force and moment that its support exerts; zero if free
    std::span<const PointValues> points = {};  // as list_rod_places orders them
    int stage = 0;
    double load_factor = 0.0;  // t of the stage: of a path it may fall
    int branch = 0;            // of a path: 0 of the main one
    // Of a stage that follows limit points, of the limit point; of others, t, too.
    double limit_load_factor = 0.0;
    std::span<const JointValues> joints = {};  // in the order of Model::joints, then of Model::gears
    std::span<const double> inputs = {};       // of Model::inputs
    // Of Model::bodies; empty where nothing is around.
    std::span<const PointSurroundings> bodies = {};
    std::span<const TendonValues> tendons = {};  // in the order of Model::tendons; empty if no history asks
    std::span<const ObstacleValues> obstacles = {};         // of Contact::obstacles; empty without contact
    std::span<const ObstacleValues> watched_contacts = {};  // on rods, as list_contact_watches orders them
    // For frames of models with contact: all that touch, the forces on the nodes, and the least gap of each.
    std::span<const ContactTouch> touches = {};
    std::span<const Vec6> contact_forces = {};
    std::span<const double> contact_gaps = {};
};

}  // namespace gxrod
