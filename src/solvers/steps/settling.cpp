#include "solvers/steps/settling.hpp"

#include <algorithm>

namespace gxrod {

namespace {

constexpr double smallest_part = 1.0 / 4096.0;

// Nothing has a rate that lasts.
void stop(std::vector<NodeMotion>& motions) {
    for (NodeMotion& motion : motions) {
        motion.v.setZero();
        motion.omega.setZero();
        motion.a.setZero();
        motion.alpha.setZero();
    }
}

}  // namespace

EquilibriumReport settle(const SolverSetup& setup,
                         const Stage& stage,
                         SolverWorkspace& workspace,
                         State& state,
                         const SettlingBooks& books) {
    const System& system = setup.system;
    const bool is_static = setup.integrator.is_static();
    const double instant = state.time;
    std::vector<Vec6> out_of_balance;
    double left = 1.0;
    double part = 1.0;
    EquilibriumReport total;
    while (left > 0.0) {
        undo_trial(state);
        if (!is_static) stop(state.trial);
        state.trial_time = stage.end_time;
        system.compute_residual(state, stage.end_time, workspace.residual);
        if (out_of_balance.empty()) out_of_balance = workspace.residual.nodal;
        books.begin();
        const double rest = std::max(left - part, 0.0);
        workspace.held_back.clear();
        for (std::size_t i = 0; rest > 0.0 && i < out_of_balance.size(); ++i)
            workspace.held_back.push_back(rest * out_of_balance[i]);
        EquilibriumReport report = solve_step(setup, stage, workspace, state);
        workspace.held_back.clear();
        report.iterations += total.iterations;
        total = report;
        if (!report.converged()) {
            part *= 0.5;
            if (part >= smallest_part) continue;
            undo_trial(state);
            return total;
        }
        if (rest > 0.0) system.compute_residual(state, stage.end_time, workspace.residual);
        books.end();
        system.commit(state, stage.end_time);
        if (!is_static) stop(state.trial);
        state.previous = state.trial;
        state.time = state.trial_time = instant;
        left = rest;
        part = std::min(2.0 * part, left);
    }
    return total;
}

}  // namespace gxrod
