#pragma once

#include <cstdint>
#include <vector>

#include "model/time/input.hpp"
#include "state/energy_jump.hpp"
#include "state/records/signal_state.hpp"
#include "state/state.hpp"
#include "state/step_memory.hpp"
#include "state/values/point_values.hpp"

namespace gxrod {

// The energy ledger of a run at an accepted step.
struct LedgerMemory {
    double initial_energy = 0.0;     // kinetic and strain
    double initial_potential = 0.0;  // potential of gravity
    double work = 0.0;               // work of loads and moving supports
    double dissipated = 0.0;
    double dissipated_by_scheme = 0.0;
    double fluid_work = 0.0;
    double contact_loss = 0.0;
    double contact_energy = 0.0;
    double initial_contact_energy = 0.0;
    // Powers at the end of the last step, for schemes with several stages.
    double driving_power = 0.0;
    double damping_power = 0.0;
    // Forces and moments per node that do work, at the end of the last step, for schemes with one stage.
    std::vector<Vec6> forces;
    std::vector<Vec6> fluid_forces;  // from water, air and ground per node, at the end of the last step
    // In statics after the first step: changes of these forces in the last step, its movements and its
    // length.
    std::vector<Vec6> force_change, movement;
    double load_step = 0.0;
    double strain_energy = 0.0;   // in statics, at the end of that step
    double largest_energy = 0.0;  // in statics: strain energy or work, so far
};

// Counts and largest values of a run so far.
struct RunTotals {
    std::int64_t steps = 0;  // accepted
    std::int64_t rejected_steps = 0;
    std::int64_t newton_iterations = 0;
    double largest_energy = 0.0;        // kinetic and strain, or external work
    double largest_energy_error = 0.0;  // largest error of the ledger
    EnergyJumps jumps;                  // in statics
};

// The place on a path of equilibria at an accepted step, whose time is the arc length.
struct PathMemory {
    double load_factor = 0.0;
    double load_scale = 0.0;  // scale of load factors relative to displacements; 0: no path
    // The unit tangent of the path.
    double load_rate = 0.0;
    std::vector<Vec6> tangent;    // (δr, δφ) of each node
    std::int64_t load_sense = 1;  // 1 if the load factor grows beyond, −1 if it falls
    std::int64_t points = 0;      // critical ones so far
};

// All data that a run needs to resume from an accepted step as if it had never stopped.
struct RestartRecord {
    std::vector<NodeMotion> nodes;                // at that step, theta zero
    std::vector<SectionHistory> sections;         // State::sections
    std::vector<double> memory;                   // State::memory
    std::vector<PairTractionRow> pair_tractions;  // State::pair_tractions
    std::vector<JointState> joints;               // State::joints_previous
    std::vector<CarriedAcceleration> carried;     // State::carried_previous; can be empty
    // Values that the step has left and that its state alone does not give again, to the last bit: reactions
    // per node, and what snapshots show of points and bodies.
    std::vector<Vec6> reactions;
    std::vector<PointValues> points;
    std::vector<double> point_places;  // rod, element, ξ and whether it is asked for, of each
    std::vector<PointSurroundings> bodies;
    LedgerMemory ledger;
    StepMemory steps;
    RunTotals totals;
    std::int64_t negative_pivots = -1;  // negative pivots of the tangent at that step, in statics
    bool is_framed = false;             // whether the last frame shows this state
    std::int64_t stage = 0;             // the last stage that took a step or found shapes, from 0
    double axis_start = 0.0;            // time, on the axis that the stages share, at which its own t is 0
    PathMemory path;                    // empty without a path
    std::vector<double> stage_ends;     // t at which each stage ended, or will end as far as is known
    std::vector<InputState> inputs;     // states of Model::inputs
    std::vector<SignalState> signals;   // in the order in which they are set
};

// A restart record with its place in a results file.
struct RestartPlace {
    RestartRecord record;
    std::uint64_t steps = 0;    // rows of the histories up to it
    std::uint64_t frames = 0;   // frames up to it
    std::uint64_t samples = 0;  // rows of the sampled histories up to it
};

}  // namespace gxrod
