#include "analyses/stepped_analysis.hpp"

namespace gxrod {

SteppedAnalysis::SteppedAnalysis(const Model& model,
                                 std::unique_ptr<Integrator> integrator,
                                 const NewtonSettings& newton,
                                 LinearSolverKind linear_solver,
                                 std::unique_ptr<StepSequence> steps)
    : system_(model),
      integrator_(std::move(integrator)),
      newton_(newton),
      workspace_(system_, linear_solver),
      steps_(std::move(steps)),
      state_(system_.initial_state()) {}

void SteppedAnalysis::accept_start() {
    integrator_->start(state_);
    system_.commit(state_, 0.0);
    reactions_ = system_.compute_reactions(workspace_.residual);
    ledger_ = std::make_unique<Ledger>(system_, *integrator_, state_, workspace_.residual);
}

bool SteppedAnalysis::take_step(EquilibriumReport& report) {
    const Stage first_stage{0, steps_->time(), steps_->time_step(), steps_->next_time()};
    const State last_accepted = state_;
    try {
        report = solve_step(system_, *integrator_, newton_, first_stage, workspace_, state_);
    } catch (...) {
        state_ = last_accepted;
        throw;
    }
    if (report.converged() && steps_->needs_error()) check_error(report);
    if (!report.converged()) state_ = last_accepted;
    return report.converged();
}

void SteppedAnalysis::check_error(EquilibriumReport& report) {
    const StepError error = integrator_->estimate_error(state_, steps_->time_step(), system_.length_scale());
    if (steps_->admits(error.size)) return;
    report.outcome = Outcome::error_too_large;
    report.step_error = error.size;
    report.worst_node = error.node;
    report.worst_component = error.component;
}

EquilibriumReport SteppedAnalysis::advance() {
    EquilibriumReport report;
    solver_row_ = SolverRow{};
    while (!take_step(report)) {
        ++solver_row_.rejected_steps;
        if (!steps_->reject()) return report;
    }
    const PhaseTimer timer(workspace_.seconds.update);
    ledger_->add_step(
        state_, {steps_->next_time(), steps_->time_step(), workspace_.residual, workspace_.stage_powers});
    reactions_ = system_.compute_reactions(workspace_.residual);
    solver_row_.time_step = steps_->time_step();
    solver_row_.newton_iterations = report.iterations;
    solver_row_.residual = report.residual;
    system_.commit(state_, steps_->next_time());
    steps_->accept();
    return report;
}

Snapshot SteppedAnalysis::snapshot() {
    section_values_ = system_.compute_section_values(state_);
    return {state_.time, state_.trial, section_values_, reactions_};
}

}  // namespace gxrod
