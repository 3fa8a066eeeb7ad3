#include "solvers/coupled/common_matrix.hpp"

#include "linear/eigen/pencil.hpp"
#include "rotation/rotation_map.hpp"
#include "solvers/newton_steps.hpp"

namespace gxrod {

namespace {

using Complex = std::complex<double>;

// Turns the displacements and spins of nodes with them in a stage, or back; a support's axes do not turn.
enum class Turn { with_nodes, back };
void turn_nodes(const StagesOfStep& stages, std::size_t j, Turn turn, std::vector<Vec6>& vectors) {
    const std::vector<NodeMotion>& motions = stages.state.stage_motions[j];
    stages.system.team().for_each_range(vectors.size(), [&](std::size_t first, std::size_t last) {
        for (std::size_t node = first; node < last; ++node) {
            const HeldComponents& held = stages.system.supports().held(static_cast<int>(node));
            const Mat3 exp = exp_matrix(motions[node].theta);
            const Mat3 Q = turn == Turn::with_nodes ? exp : Mat3(exp.transpose());
            Vec6& vector = vectors[node];
            if (!held[0] && !held[1] && !held[2]) vector.head<3>() = (Q * vector.head<3>()).eval();
            if (!held[3] && !held[4] && !held[5]) vector.tail<3>() = (Q * vector.tail<3>()).eval();
        }
    });
}

}  // namespace

CommonMatrix::CommonMatrix(const System& system, LinearSolverKind kind)
    : complex_solver_(kind, system.pattern(), system.team()) {}

// With S(λ) = K + λ/Δt C + (λ/Δt)² M: that of the typical factor is known, joints included.
bool CommonMatrix::factorize(const StagesOfStep& stages,
                             SolverWorkspace& workspace,
                             EquilibriumReport& report) {
    State& state = stages.state;
    const double known = stages.scheme.typical_factor() / stages.step.time_step;
    {
        const PhaseTimer timer(workspace.seconds.assembly);
        state.trial = state.previous;
        state.joints_trial = state.joints_previous;
        state.trial_time = stages.step.step_time;
        const auto compute = [&](const NodeLinearization& one, std::vector<double>& values) {
            workspace.linearizations.assign(state.trial.size(), one);
            stages.system.compute_tangent(
                state, stages.step.step_time, workspace.linearizations, values, stages.tangent_request());
        };
        const Mat3 I = Mat3::Identity();
        compute({1.0, known, known * known, known * I, known * known * I}, workspace.values);
        compute({.rate = 1.0, .d_omega = I}, damping_);
        compute({.acceleration = 1.0, .d_alpha = I}, mass_);
    }
    if (stages.scheme.real_factor() > 0.0 && !gxrod::factorize(stages.system, workspace, report))
        return false;
    const PhaseTimer timer(workspace.seconds.solve);
    const Complex factor = stages.scheme.complex_factor() / stages.step.time_step;
    const Complex of_damping = factor - known;
    const Complex of_mass = factor * factor - known * known;
    real_.resize(workspace.values.size());
    imaginary_.resize(workspace.values.size());
    for (std::size_t i = 0; i < real_.size(); ++i) {
        const Complex added = of_damping * damping_[i] + of_mass * mass_[i];
        real_[i] = workspace.values[i] + added.real();
        imaginary_[i] = added.imag();
    }
    // Between K, at the angle 0, and λ² M.
    const double half_angle = std::arg(stages.scheme.complex_factor());
    factors_.setConstant(stages.system.equations().count(), std::polar(1.0, -half_angle));
    turn_joints(stages.system, half_angle);
    if (complex_solver_.factorize(real_, imaginary_, factors_).regular) return true;
    report.outcome = Outcome::singular;
    return false;
}

// The equations of joints the other way, so that what elimination leaves of them is definite.
void CommonMatrix::turn_joints(const System& system, double half_angle) {
    const std::vector<AttachedUnknowns>& attached = system.joints().attached();
    for (std::size_t i = 0; i < attached.size(); ++i)
        factors_.segment(system.equations().of_attached(i), attached[i].count)
            .setConstant(std::polar(1.0, half_angle));
}

void CommonMatrix::solve(const StagesOfStep& stages,
                         const std::vector<Residual>& residuals,
                         SolverWorkspace& workspace,
                         std::vector<Eigen::VectorXd>& increments) {
    const PhaseTimer timer(workspace.seconds.solve);
    const EquationNumbers& equations = stages.system.equations();
    const auto size = static_cast<Eigen::Index>(equations.count());
    Eigen::VectorXd real = Eigen::VectorXd::Zero(size);
    Eigen::VectorXcd complex = Eigen::VectorXcd::Zero(size);
    const std::vector<std::vector<double>> rows = stages.convert_rows(residuals);
    for (std::size_t j = 0; j < stages.count(); ++j) {
        nodal_ = residuals[j].nodal;
        turn_nodes(stages, j, Turn::back, nodal_);
        Eigen::VectorXd right_side = gather(nodal_, equations, stages.system.team());
        if (!stages.system.joints().empty())
            stages.system.joints().set_rows(rows[j], workspace.values, right_side);
        real -= stages.scheme.to_real()[static_cast<Eigen::Index>(j)] * right_side;
        complex -= stages.scheme.to_complex()[static_cast<Eigen::Index>(j)] * right_side;
    }
    if (stages.scheme.real_factor() > 0.0) workspace.linear_solver->solve(real);
    complex_solver_.solve(complex);
    increments.resize(stages.count());
    for (std::size_t j = 0; j < stages.count(); ++j) {
        const auto index = static_cast<Eigen::Index>(j);
        increments[j] = stages.scheme.from_real()[index] * real +
                        2.0 * (stages.scheme.from_complex()[index] * complex).real();
    }
}

void CommonMatrix::turn_increments(const StagesOfStep& stages, std::size_t j, std::vector<Vec6>& increments) {
    turn_nodes(stages, j, Turn::with_nodes, increments);
}

void CommonMatrix::estimate_errors(const StagesOfStep& stages,
                                   SolverWorkspace& workspace,
                                   std::vector<Vec6>& placements,
                                   std::vector<Vec6>& rates) const {
    const EquationNumbers& equations = stages.system.equations();
    const std::size_t nodes = stages.state.previous.size();
    const double time_step = stages.step.time_step;
    const double factor = stages.scheme.real_factor() / time_step;
    placements.resize(nodes);
    rates.resize(nodes);
    for (std::size_t node = 0; node < nodes; ++node) {
        const CoupledStages::Defect defect = stages.scheme.compute_defect(stages.state, time_step, node);
        rates[node] = defect.rates;
        placements[node] = defect.accelerations + factor * defect.rates;
    }
    // S(λ) e_r = M (q + λ/Δt p) + C p, e_v = λ/Δt e_r − p.
    const SparsePattern& pattern = stages.system.pattern();
    const ThreadTeam& team = stages.system.team();
    Eigen::VectorXd vector = multiply(pattern, mass_, gather(placements, equations, team)) +
                             multiply(pattern, damping_, gather(rates, equations, team));
    workspace.linear_solver->solve(vector);
    for (std::size_t node = 0; node < nodes; ++node) {
        placements[node] = equations.increment_of(static_cast<int>(node), vector);
        rates[node] = time_step * (factor * placements[node] - rates[node]);
    }
}

}  // namespace gxrod
