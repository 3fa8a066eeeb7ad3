#include "solvers/equilibrium.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "assembly/contact/contacts.hpp"
#include "assembly/system_measures.hpp"
#include "solvers/coupled/coupled_step.hpp"
#include "solvers/hidden_constraints.hpp"
#include "solvers/newton_steps.hpp"
#include "solvers/paired_matrix.hpp"

namespace gxrod {

SolverWorkspace::SolverWorkspace(const System& system, LinearSolverKind kind)
    : linear_solver(make_linear_solver(kind, system.pattern(), system.team())) {
    if (Contacts(system).couple_rods()) paired = std::make_unique<PairedMatrix>(system, kind);
}
SolverWorkspace::~SolverWorkspace() = default;
SolverWorkspace::SolverWorkspace(SolverWorkspace&&) noexcept = default;

namespace {

double compute_power_of(const std::vector<Vec6>& forces, const std::vector<NodeMotion>& motions) {
    double power = 0.0;
    for (std::size_t i = 0; i < forces.size(); ++i) {
        power += forces[i].head<3>().dot(motions[i].v) + forces[i].tail<3>().dot(motions[i].omega);
    }
    return power;
}

}  // namespace

Power compute_power(
    const System& system, const State& state, double time, const Residual& residual, const TimeSpan& step) {
    Power power;
    std::vector<Vec6> forces = SystemMeasures(system).compute_load_forces(state, time);
    SystemMeasures(system).add_support_forces(residual, forces);
    power.driving =
        compute_power_of(forces, state.trial) + system.joints().compute_driving_power(state, time, step);
    power.damping = SystemMeasures(system).compute_damping_power(state);
    power.contact = Contacts(system).compute_power(state, time);
    return power;
}

EquilibriumReport solve_accelerations(
    const System& system, double time, const TimeSpan& step, SolverWorkspace& workspace, State& state) {
    EquilibriumReport report;
    for (NodeMotion& motion : state.trial) {
        motion.a.setZero();
        motion.alpha.setZero();
    }
    system.supports().set_rates(time, step, state.trial);
    ConstraintRequest request{ConstraintLevel::acceleration, step};
    request.stops = StopChoice::at_end;
    if (Contacts(system).are_impulses()) request.contact_weight = 0.0;
    system.compute_residual(state, time, workspace.residual, request);
    measure_residual(system, workspace.residual, report);
    if (report.outcome == Outcome::not_finite) return report;
    system.compute_tangent(state, time, mass_linearizations(state.trial.size()), workspace.values, request);
    if (!factorize(system, workspace, report)) return report;
    ++report.iterations;
    Eigen::VectorXd residual = gather_residual(system, workspace.residual, workspace.values);
    if (!solve_increment(system, residual, workspace, report)) return report;
    add_accelerations(system, workspace, state);
    // What the regularization of JointAssembly leaves of the equations of joints; nodes are in balance,
    // unless friction follows the multipliers, which are found here.
    const bool rubs = system.joints().have_friction_by_multipliers();
    const int corrections = count_corrections(system);
    for (int i = 0; i < corrections; ++i) {
        if (rubs) {
            system.compute_residual(state, time, workspace.residual, request);
            residual = gather_residual(system, workspace.residual, workspace.values);
        } else {
            residual.setZero();
            system.joints().compute_rows(state, time, request, workspace.residual.rows);
            system.joints().set_rows(workspace.residual.rows, workspace.values, residual);
        }
        if (!solve_increment(system, residual, workspace, report)) return report;
        add_accelerations(system, workspace, state);
    }
    system.compute_residual(state, time, workspace.residual, request);
    measure_residual(system, workspace.residual, report);
    return report;
}

namespace {

// Whether the rates of an explicit step turn a node by less than half a turn, and no element's nodes against
// each other by more.
bool check_rotations(const System& system,
                     const Stage& stage,
                     const State& state,
                     EquilibriumReport& report) {
    constexpr double half_turn = std::numbers::pi;
    std::vector<Vec3> spins(state.trial.size());
    for (std::size_t node = 0; node < spins.size(); ++node) {
        const NodeMotion& trial = state.trial[node];
        const double rate = std::max(trial.omega.norm(), state.previous[node].omega.norm());
        spins[node] = trial.theta;
        if (stage.time_step * rate < half_turn) continue;
        report.outcome = std::isfinite(rate) ? Outcome::rotation_too_large : Outcome::not_finite;
        report.worst_node = static_cast<int>(node);
        report.worst_component = -1;
        return false;
    }
    const RelativeRotation bound = SystemMeasures(system).bound_relative_rotation(state.previous, spins);
    if (bound.angle < half_turn) return true;
    report.outcome = Outcome::element_too_turned;
    report.worst_node = bound.node;
    report.worst_component = -1;
    return false;
}

EquilibriumReport solve_stage_explicitly(const System& system,
                                         const Integrator& integrator,
                                         const Stage& stage,
                                         SolverWorkspace& workspace,
                                         State& state) {
    const double time = integrator.stage_time(stage);
    integrator.begin_stage(state, stage, system.team());
    system.supports().place(time, state);
    EquilibriumReport report;
    const bool is_last = stage.index + 1 == integrator.stage_count();
    if (is_last && !check_rotations(system, stage, state, report)) return report;
    const TimeSpan step{stage.step_time, stage.time_step};
    if (is_last && has_hidden_constraints(system)) {
        // With the mass matrix of the stage before.
        project_positions(system, time, workspace, state, report);
        if (report.converged()) project_velocities(system, time, step, workspace, state, report);
        if (!report.converged()) return report;
    }
    return solve_accelerations(system, time, step, workspace, state);
}

// Accelerations without contact, of a step whose equilibrium has impulses of it. The residual is then that of
// the mean accelerations over the step, in which impulses are forces.
void split_contact(const System& system,
                   const Integrator& integrator,
                   const Stage& stage,
                   SolverWorkspace& workspace,
                   State& state,
                   EquilibriumReport& report) {
    const Contacts contacts(system);
    if (!contacts.are_impulses() || !contacts.have_forces(state, stage.end_time)) return;
    const TimeSpan step{stage.step_time, stage.time_step};
    std::vector<Vec6> shocked(state.trial.size());
    for (std::size_t i = 0; i < shocked.size(); ++i) shocked[i] << state.trial[i].a, state.trial[i].alpha;
    const EquilibriumReport smooth = solve_accelerations(system, stage.end_time, step, workspace, state);
    if (!smooth.converged()) {
        report.outcome = smooth.outcome;
        return;
    }
    integrator.split_impulses(state, stage, shocked);
    const auto exchange = [&] {
        for (std::size_t i = 0; i < shocked.size(); ++i) {
            Vec6 before;
            before << state.trial[i].a, state.trial[i].alpha;
            state.trial[i].a = shocked[i].head<3>();
            state.trial[i].alpha = shocked[i].tail<3>();
            shocked[i] = before;
        }
    };
    exchange();
    system.compute_residual(state, stage.end_time, workspace.residual, {ConstraintLevel::position, step});
    exchange();
}

// Makes what went wrong at the end of a step that of the step.
void report_end(const EquilibriumReport& end, EquilibriumReport& report) {
    const int iterations = report.iterations;
    report = end;
    report.iterations = iterations;
}

// Lists (a, α) of each node, from which the impulses of stops are to be taken; none without stops.
std::vector<Vec6> list_accelerations(const System& system, const State& state) {
    std::vector<Vec6> accelerations;
    if (!system.joints().have_stops()) return accelerations;
    for (const NodeMotion& motion : state.trial)
        (accelerations.emplace_back() << motion.a, motion.alpha).finished();
    return accelerations;
}

// Of an implicit step that has converged.
void restore_hidden_constraints(const System& system,
                                const Stage& stage,
                                SolverWorkspace& workspace,
                                State& state,
                                EquilibriumReport& report) {
    const TimeSpan step{stage.step_time, stage.time_step};
    // What a stop stops loses its velocity by the mass that meets it: the masses' matrix comes first.
    if (system.joints().have_stops()) {
        const EquilibriumReport met = solve_accelerations(system, stage.end_time, step, workspace, state);
        if (!met.converged()) return report_end(met, report);
    }
    project_velocities(system, stage.end_time, step, workspace, state, report);
    if (!report.converged()) return;
    const EquilibriumReport end = solve_accelerations(system, stage.end_time, step, workspace, state);
    if (!end.converged()) report_end(end, report);
}

// Where the end of the step is not a stage, or joints have to be met there, accelerations are found anew.
EquilibriumReport solve_together(const System& system,
                                 const CoupledStages& scheme,
                                 const NewtonSettings& settings,
                                 const Stage& step,
                                 SolverWorkspace& workspace,
                                 State& state) {
    EquilibriumReport report = solve_coupled_step(system, scheme, settings, step, workspace, state);
    const bool has_hidden = has_hidden_constraints(system);
    if (!report.converged() || (scheme.ends_with_stage() && !has_hidden)) return report;
    const TimeSpan span{step.step_time, step.time_step};
    system.supports().place(step.end_time, state);
    system.supports().set_rates(step.end_time, span, state.trial);
    EquilibriumReport end = solve_accelerations(system, step.end_time, span, workspace, state);
    if (end.converged() && has_hidden) {
        project_positions(system, step.end_time, workspace, state, end);
        if (end.converged()) restore_hidden_constraints(system, step, workspace, state, end);
    }
    if (!end.converged()) report_end(end, report);
    return report;
}

EquilibriumReport solve_stages(const SolverSetup& setup,
                               const Stage& first_stage,
                               std::optional<ConstraintLevel> level,
                               SolverWorkspace& workspace,
                               State& state) {
    const System& system = setup.system;
    const Integrator& integrator = setup.integrator;
    EquilibriumReport total;
    Stage stage = first_stage;
    const bool weighs_power = !integrator.power_weights().empty();
    workspace.stage_powers.clear();
    for (stage.index = 0; stage.index < integrator.stage_count(); ++stage.index) {
        EquilibriumReport report = integrator.is_explicit()
                                       ? solve_stage_explicitly(system, integrator, stage, workspace, state)
                                       : solve_equilibrium(setup, stage, workspace, state, level);
        report.iterations += total.iterations;
        if (system.model().has_inertia) {
            report.shortened += total.shortened;
            report.least_gap = std::min(report.least_gap, total.least_gap);
        }
        total = report;
        if (!report.converged()) break;
        integrator.end_stage(state, stage, system.team());
        if (weighs_power) {
            const double time = integrator.stage_time(stage);
            workspace.stage_powers.push_back(
                compute_power(system, state, time, workspace.residual, {stage.step_time, stage.time_step}));
        }
    }
    const bool is_implicit = !integrator.is_explicit() && !integrator.is_static();
    if (total.converged() && is_implicit && has_hidden_constraints(system)) {
        std::vector<Vec6> shocked = list_accelerations(system, state);
        restore_hidden_constraints(system, stage, workspace, state, total);
        if (total.converged() && system.joints().has_just_stopped(state))
            integrator.split_impulses(state, stage, shocked);
    }
    if (total.converged() && is_implicit && system.model().has_inertia)
        split_contact(system, integrator, stage, workspace, state, total);
    return total;
}

// Whether a stage meets joints by accelerations, though it is implicit.
bool asks_for_accelerations(const System& system, const Integrator& integrator) {
    if (integrator.is_explicit() || !has_hidden_constraints(system)) return false;
    for (int stage = 0; stage < integrator.stage_count(); ++stage) {
        if (integrator.constraint_level(stage) == ConstraintLevel::acceleration) return true;
    }
    return false;
}

// Where bars come into line the accelerations of joints have a pole within the step; positions have none.
EquilibriumReport solve_in_turn(const SolverSetup& setup,
                                const Stage& first_stage,
                                SolverWorkspace& workspace,
                                State& state) {
    EquilibriumReport report = solve_stages(setup, first_stage, std::nullopt, workspace, state);
    if (report.converged() || !asks_for_accelerations(setup.system, setup.integrator)) return report;
    const int before = report.iterations;
    report = solve_stages(setup, first_stage, ConstraintLevel::position, workspace, state);
    report.iterations += before;
    return report;
}

}  // namespace

EquilibriumReport solve_step(const SolverSetup& setup,
                             const Stage& first_stage,
                             SolverWorkspace& workspace,
                             State& state) {
    if (const CoupledStages* coupled = setup.integrator.coupled())
        return solve_together(setup.system, *coupled, setup.settings, first_stage, workspace, state);
    return solve_in_turn(setup, first_stage, workspace, state);
}

}  // namespace gxrod
