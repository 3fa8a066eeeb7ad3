#pragma once

#include <Eigen/Core>
#include <limits>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "assembly/contact/contact_work.hpp"
#include "assembly/system.hpp"
#include "integrators/integrator.hpp"
#include "linear/linear_solver.hpp"
#include "machine/phase_timer.hpp"

namespace gxrod {

class FrameColumns;
struct CoupledWorkspace;
class PairedMatrix;

enum class Outcome {
    converged,
    out_of_iterations,    // the residual did not fall below the tolerance
    singular,             // the tangent (or mass) matrix has no inverse
    not_finite,           // a residual or an increment is not a number
    rotation_too_large,   // a node turns by π or more within the step
    element_too_turned,   // nodes of one element are turned against each other by nearly π
    error_too_large,      // the step's estimated error is above its tolerance
    energy_out_of_reach,  // no moderate scaling of the vibrations' rates gives the energy that is due
    joints_open,          // joints cannot be closed, or velocities do not fit them
    control_turned,       // the displacement that controls a path turns back
    path_crawls,          // a path's steps stay short compared with earlier ones
    lost_stability        // the step is good, but shorter ones seek what it may have passed: a stable
                          // equilibrium, or, on a path, a bend or critical points
};

// The outcome of the search for one equilibrium. A failure to converge is a value, not an exception.
struct EquilibriumReport {
    Outcome outcome = Outcome::converged;
    int iterations = 0;     // linear solves
    double residual = 0.0;  // the larger of force and moment, each relative to its scale
    int worst_node = -1;    // node of the residual, the pivot, the rotation or the non-finite number
    int worst_component = -1;
    double step_error = 0.0;                                     // the estimate for error_too_large
    LargestGap joint_gap;                                        // gap of the equations of joints
    double least_gap = std::numeric_limits<double>::infinity();  // least gap of contact in all iterations
    int shortened = 0;                  // iterations whose increment contact has shortened
    std::int64_t negative_pivots = -1;  // for nodes' unknowns in the last factorization; −1: not known

    bool converged() const { return outcome == Outcome::converged; }
};

// Powers at one instant.
struct Power {
    double driving = 0.0;  // by loads and moving supports
    double damping = 0.0;  // dissipated
    ContactPower contact = {};
};

// Computes the power at the trial motions with their residual; `step` is the step that `time` belongs to, if
// any.
Power compute_power(const System& system,
                    const State& state,
                    double time,
                    const Residual& residual,
                    const TimeSpan& step = {0.0, 0.0});

// Memory for solving in addition to the State, allocated once.
struct SolverWorkspace {
    Residual residual;
    std::vector<NodeLinearization> linearizations;
    std::vector<double> values;
    Eigen::VectorXd vector;
    std::vector<Vec6> increments;  // (δr, δφ) of each node
    std::unique_ptr<LinearSolver> linear_solver;
    // The matrix in which Newton's method solves if rods touch each other; else null.
    std::unique_ptr<PairedMatrix> paired;
    bool is_paired = false;           // whether `paired` holds the matrix
    std::vector<Power> stage_powers;  // powers in the last step, if the scheme weighs them
    PhaseSeconds seconds;
    const FrameColumns* frame =
        nullptr;  // columns that a rotating frame adds to the tangent, if there is one

    // Spatial forces and moments on nodes that Newton's method takes from the residual; empty without any.
    std::vector<Vec6> held_back;

    std::unique_ptr<CoupledWorkspace> coupled;  // for stages that are found together, from the first step on

    SolverWorkspace(const System& system, LinearSolverKind kind);
    ~SolverWorkspace();
    SolverWorkspace(SolverWorkspace&&) noexcept;
};

// The parts that all equilibria of an analysis share.
struct SolverSetup {
    const System& system;
    const Integrator& integrator;
    const NewtonSettings& settings;
};

// Finds the equilibrium of one stage of an implicit scheme by Newton's method, from the integrator's
// prediction. If the mixed tangent fails, tries the consistent one from the same prediction; with `automatic`
// the other way round.
//
// It has converged when the largest residual force and moment are below tolerance times the largest force and
// moment that an element, joint or load puts on a node, and joints are closed to 1e-12 of the length of their
// part. If round-off hides that, it has converged when the last increment was below 1e-4 × tolerance or four
// units of rounding; or the next one would be (by the ratio of the last two) and the residual, not as large
// as all forces, no longer falls; or the last one was below 1e-10 and no longer shrinking (δr relative to the
// model's length or the node's distance from the origin, δφ in rad). `level`: level at which joints are met,
// in place of the integrator's.
EquilibriumReport solve_equilibrium(const SolverSetup& setup,
                                    const Stage& stage,
                                    SolverWorkspace& workspace,
                                    State& state,
                                    std::optional<ConstraintLevel> level = std::nullopt);

// Sets the trial accelerations, and the multipliers of joints, from equilibrium at the trial's positions,
// rotations and velocities: M a − Gᵀλ = f, with the equations of joints at the level of accelerations.
// Supports first set the accelerations of their components, by differences within `step`, which `time`
// belongs to.
EquilibriumReport solve_accelerations(
    const System& system, double time, const TimeSpan& step, SolverWorkspace& workspace, State& state);

// Solves one whole step of any scheme: each stage in turn, until one fails. The trial motions hold the
// result.
EquilibriumReport solve_step(const SolverSetup& setup,
                             const Stage& first_stage,
                             SolverWorkspace& workspace,
                             State& state);

}  // namespace gxrod
