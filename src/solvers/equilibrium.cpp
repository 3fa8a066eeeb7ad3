#include "solvers/equilibrium.hpp"

#include <fmt/format.h>

#include <cmath>
#include <limits>
#include <numbers>

#include "solvers/difference_tangent.hpp"
#include "state/increment.hpp"

namespace gxrod {

namespace {

// The residual's size relative to its scales, and where it is largest.
void measure_residual(const System& system, const Residual& residual, EquilibriumReport& report) {
    const double length = system.length_scale();
    // A force at the model's length is a moment: neither scale falls to round-off of the other.
    const double force_scale = std::max(residual.force_scale, 1e-6 * residual.moment_scale / length);
    const double moment_scale = std::max(residual.moment_scale, 1e-6 * residual.force_scale * length);
    report.residual = 0.0;
    for (const auto& [node, component] : system.equations().unknowns()) {
        const double value = std::abs(residual.nodal[node][component]);
        if (value == 0.0) continue;
        const double scaled = value / (component < 3 ? force_scale : moment_scale);
        if (!std::isfinite(scaled)) {
            report.outcome = Outcome::not_finite;
            report.worst_node = node;
            report.worst_component = component;
            report.residual = scaled;
            return;
        }
        if (scaled > report.residual) {
            report.residual = scaled;
            report.worst_node = node;
            report.worst_component = component;
        }
    }
}

double largest_component(const System& system, const Residual& residual) {
    double largest = 0.0;
    for (const auto& [node, component] : system.equations().unknowns()) {
        largest = std::max(largest, std::abs(residual.nodal[node][component]));
    }
    return largest;
}

// Solves with the factorized tangent for minus the residual; false if that is not finite.
bool solve_increment(const System& system, SolverWorkspace& workspace, EquilibriumReport& report) {
    const PhaseTimer timer(workspace.seconds.solve);
    workspace.vector = -gather(workspace.residual.nodal, system.equations());
    workspace.linear_solver->solve(workspace.vector);
    for (std::int64_t i = 0; i < workspace.vector.size(); ++i) {
        if (std::isfinite(workspace.vector[i])) continue;
        report.outcome = Outcome::not_finite;
        report.worst_node = system.equations().unknown(i).node;
        report.worst_component = system.equations().unknown(i).component;
        return false;
    }
    return true;
}

bool factorize(const System& system, SolverWorkspace& workspace, EquilibriumReport& report) {
    const PhaseTimer timer(workspace.seconds.solve);
    const Factorization factorization = workspace.linear_solver->factorize(workspace.values);
    if (factorization.regular) return true;
    report.outcome = Outcome::singular;
    report.worst_node = report.worst_component = -1;
    if (factorization.singular_equation >= 0) {
        report.worst_node = system.equations().unknown(factorization.singular_equation).node;
        report.worst_component = system.equations().unknown(factorization.singular_equation).component;
    }
    return false;
}

// Newton's method on one stage; the members are what its steps share.
class Equilibrium {
  public:
    Equilibrium(const System& system,
                const Integrator& integrator,
                const NewtonSettings& settings,
                const Stage& stage,
                SolverWorkspace& workspace,
                State& state)
        : system_(system),
          integrator_(integrator),
          settings_(settings),
          stage_(stage),
          workspace_(workspace),
          state_(state) {}

    EquilibriumReport solve() {
        predict();
        while (reject_large_rotation() && !is_done()) {
            compute_tangent();
            if (!factorize(system_, workspace_, report_)) break;
            ++report_.iterations;
            if (!solve_increment(system_, workspace_, report_)) break;
            apply_increment();
        }
        return report_;
    }

  private:
    void predict() {
        const PhaseTimer timer(workspace_.seconds.update);
        integrator_.begin_stage(state_, stage_);
    }

    // Whether to stop, be it converged, out of iterations or no number.
    bool is_done() {
        const PhaseTimer timer(workspace_.seconds.assembly);
        system_.compute_residual(state_, integrator_.stage_time(stage_), workspace_.residual);
        measure_residual(system_, workspace_.residual, report_);
        if (report_.outcome == Outcome::not_finite) return true;
        const bool small =
            settings_.absolute_residual > 0.0
                ? largest_component(system_, workspace_.residual) <= settings_.absolute_residual
                : report_.residual <= settings_.tolerance;
        if (small || has_reached_round_off()) return true;
        if (report_.iterations < settings_.max_iterations) return false;
        report_.outcome = Outcome::out_of_iterations;
        return true;
    }

    // Whether round-off is all that is left of the increments: far below the tolerance, a few units of the
    // last place, or small and no longer shrinking.
    bool has_reached_round_off() const {
        constexpr double rounding = 4.0 * std::numeric_limits<double>::epsilon();
        if (last_increment_ <= std::max(1e-4 * settings_.tolerance, rounding)) return true;
        return last_increment_ <= 1e-10 && last_increment_ >= 0.5 * increment_before_;
    }

    void compute_tangent() {
        const PhaseTimer timer(workspace_.seconds.assembly);
        workspace_.linearizations.resize(state_.trial.size());
        const double time = integrator_.stage_time(stage_);
        switch (settings_.tangent) {
            case TangentKind::consistent:
                integrator_.linearize(state_, stage_, workspace_.linearizations);
                system_.compute_tangent(state_, time, workspace_.linearizations, workspace_.values);
                break;
            case TangentKind::paper:
                integrator_.linearize_as_paper(state_, stage_, workspace_.linearizations);
                system_.compute_tangent(state_, time, workspace_.linearizations, workspace_.values);
                break;
            case TangentKind::difference:
                DifferenceTangent(system_).compute(integrator_, stage_, state_, workspace_.values);
                break;
        }
    }

    void apply_increment() {
        const PhaseTimer timer(workspace_.seconds.update);
        increment_before_ = last_increment_;
        last_increment_ = 0.0;
        for (std::size_t node = 0; node < state_.trial.size(); ++node) {
            const auto& equations = system_.equations().of_node(static_cast<int>(node));
            Vec6 delta;
            for (int i = 0; i < 6; ++i) delta[i] = equations[i] < 0 ? 0.0 : workspace_.vector[equations[i]];
            const Vec3 delta_r = delta.head<3>();
            const Vec3 delta_phi = delta.tail<3>();
            NodeMotion& trial = state_.trial[node];
            last_increment_ = std::max(
                {last_increment_,
                 delta_r.lpNorm<Eigen::Infinity>() / std::max(system_.length_scale(), trial.r.norm()),
                 delta_phi.lpNorm<Eigen::Infinity>()});
            if (settings_.tangent == TangentKind::paper) {
                place(state_.previous[node], trial.r + delta_r, trial.theta + delta_phi, trial);
            } else {
                apply_spin(state_.previous[node], delta_r, delta_phi, trial);
            }
        }
        integrator_.update_rates(state_, stage_);
    }

    // False, and so reported, if a node turned by π or more since the last accepted step.
    bool reject_large_rotation() {
        for (std::size_t node = 0; node < state_.trial.size(); ++node) {
            if (state_.trial[node].theta.norm() < std::numbers::pi) continue;
            report_.outcome = Outcome::rotation_too_large;
            report_.worst_node = static_cast<int>(node);
            report_.worst_component = -1;
            return false;
        }
        return true;
    }

    const System& system_;
    const Integrator& integrator_;
    const NewtonSettings& settings_;
    const Stage& stage_;
    SolverWorkspace& workspace_;
    State& state_;
    EquilibriumReport report_;
    // The largest |δr| relative to its scale, or |δφ|, of the last two iterations.
    double last_increment_ = std::numeric_limits<double>::infinity();
    double increment_before_ = std::numeric_limits<double>::infinity();
};

}  // namespace

SolverWorkspace::SolverWorkspace(const System& system, LinearSolverKind kind)
    : linear_solver(make_linear_solver(kind, system.pattern())) {}

std::string describe(const EquilibriumReport& report, const Model& model) {
    static constexpr const char* components[6] = {"x", "y", "z", "rx", "ry", "rz"};
    std::string where = report.worst_node >= 0 ? " at " + model.nodes[report.worst_node].name : "";
    if (report.worst_node >= 0 && report.worst_component >= 0) {
        where += fmt::format(" ({})", components[report.worst_component]);
    }
    switch (report.outcome) {
        case Outcome::converged:
            break;
        case Outcome::out_of_iterations:
            return fmt::format(
                "Newton's method did not converge in {} iterations; the residual, {:.2e} of the largest "
                "force or moment, is largest{}",
                report.iterations,
                report.residual,
                where);
        case Outcome::singular:
            return fmt::format("the system of equations is singular{}", where);
        case Outcome::not_finite:
            return fmt::format("a force or increment is not a finite number{}", where);
        case Outcome::rotation_too_large:
            return fmt::format("the rotation within one step reaches half a turn{}; take smaller steps",
                               where);
    }
    return "converged";
}

EquilibriumReport solve_equilibrium(const System& system,
                                    const Integrator& integrator,
                                    const NewtonSettings& settings,
                                    const Stage& stage,
                                    SolverWorkspace& workspace,
                                    State& state) {
    return Equilibrium(system, integrator, settings, stage, workspace, state).solve();
}

EquilibriumReport solve_accelerations(const System& system,
                                      double time,
                                      SolverWorkspace& workspace,
                                      State& state) {
    EquilibriumReport report;
    for (NodeMotion& motion : state.trial) {
        motion.a.setZero();
        motion.alpha.setZero();
    }
    system.compute_residual(state, time, workspace.residual);
    measure_residual(system, workspace.residual, report);
    if (report.outcome == Outcome::not_finite) return report;
    system.compute_tangent(state, time, mass_linearizations(state.trial.size()), workspace.values);
    if (!factorize(system, workspace, report)) return report;
    ++report.iterations;
    if (!solve_increment(system, workspace, report)) return report;
    std::int64_t equation = 0;
    for (const auto& [node, component] : system.equations().unknowns()) {
        Vec3& target = component < 3 ? state.trial[node].a : state.trial[node].alpha;
        target[component % 3] = workspace.vector[equation++];
    }
    system.compute_residual(state, time, workspace.residual);
    measure_residual(system, workspace.residual, report);
    return report;
}

EquilibriumReport solve_step(const System& system,
                             const Integrator& integrator,
                             const NewtonSettings& settings,
                             const Stage& first_stage,
                             SolverWorkspace& workspace,
                             State& state) {
    EquilibriumReport total;
    Stage stage = first_stage;
    const bool weighs_power = !integrator.power_weights().empty();
    workspace.load_power.clear();
    if (weighs_power)
        workspace.load_power.push_back(system.compute_load_power(state.previous, stage.step_time));
    for (stage.index = 0; stage.index < integrator.stage_count(); ++stage.index) {
        EquilibriumReport report;
        if (integrator.is_explicit()) {
            integrator.begin_stage(state, stage);
            report = solve_accelerations(system, integrator.stage_time(stage), workspace, state);
        } else {
            report = solve_equilibrium(system, integrator, settings, stage, workspace, state);
        }
        report.iterations += total.iterations;
        total = report;
        if (!report.converged()) break;
        integrator.end_stage(state, stage);
        if (weighs_power) {
            workspace.load_power.push_back(
                system.compute_load_power(state.trial, integrator.stage_time(stage)));
        }
    }
    return total;
}

}  // namespace gxrod
