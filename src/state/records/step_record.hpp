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
#include "state/values/tie_values.hpp"

// The data that an analysis passes to the results at an accepted step.
namespace gxrod {

struct LedgerRow {
    double kinetic_energy = 0.0;
    double strain_energy = 0.0;
    double external_work = 0.0;          // by loads with gravity since t = 0
    double fluid_work = 0.0;             // the part of it by water, air and the ground
    double contact_energy = 0.0;         // stored in contact of rods
    double contact_loss = 0.0;           // lost by impacts and friction of contact since t = 0
    double work_uncertainty = 0.0;       // uncertainty of the work in the last load step; 0 in dynamics
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
    double residual = 0.0;      // scaled, at the last equilibrium
    int rejected_steps = 0;     // trials cut before this step was accepted
    // With contact: number of places that touch; least gap in any iteration; iterations whose increment
    // contact has shortened.
    std::int64_t contacts = 0;
    double least_gap = 0.0;
    int shortened = 0;
    // Negative pivots of the tangent at a static equilibrium: the number of unstable shapes. −1: not known,
    // for example if loads have no potential.
    std::int64_t negative_pivots = -1;
};

// The accepted state and what is derived from it. Valid only during the call that passes it.
struct Snapshot {
    double time;  // on the axis that stages share
    std::span<const NodeMotion> nodes;
    // Elements of all rods, in the order of Model::rods, from start to end; for frames, empty without one.
    std::span<const SectionValues> elements;
    std::span<const Vec6> reactions;  // per node: force and moment that its support exerts; zero if free
    std::span<const PointValues> points = {};  // as list_rod_places orders them
    int stage = 0;
    double load_factor = 0.0;  // t of the stage; on a path it may fall
    int branch = 0;            // branch of a path; 0: the main one
    // Load factor of the limit point in a stage that follows limit points; in other stages t, too.
    double limit_load_factor = 0.0;
    const TieValues* ties = nullptr;  // nullptr only if nobody asks for springs and bushings
    // In the order of Model::joints, then of Model::gears, then of Model::sleeves.
    std::span<const JointValues> joints = {};
    std::span<const double> inputs = {};  // values of Model::inputs
    // Surroundings of Model::bodies; empty if the model has none.
    std::span<const PointSurroundings> bodies = {};
    std::span<const TendonValues> tendons = {};  // in the order of Model::tendons; empty if no history asks
    std::span<const ObstacleValues> obstacles = {};         // as Contact::obstacles; empty without contact
    std::span<const ObstacleValues> watched_contacts = {};  // on rods, in the order of list_contact_watches
    // For frames of models with contact: all places that touch, the forces on nodes, and the least gap of
    // each node.
    std::span<const ContactTouch> touches = {};
    std::span<const Vec6> contact_forces = {};
    std::span<const double> contact_gaps = {};
    // For frames: p_i A_i − p_o A_o at the middle of each element, of models with rods in water; the force of
    // the ground per length of the rods at each node, of models with rods that it can touch.
    std::span<const double> pressure_forces = {};
    std::span<const Vec3> bed_forces = {};
    bool has_ground = true;  // false in a stage in which the ground of the model does not act
};

}  // namespace gxrod
