#include "analyses/dynamic.hpp"

namespace gxrod {

DynamicAnalysis::DynamicAnalysis(const Model& model, const DynamicSettings& settings)
    : system_(model),
      settings_(settings),
      integrator_(make_integrator(settings)),
      workspace_(system_, settings.linear_solver),
      control_(settings.end_time, settings.steps),
      state_(system_.initial_state()) {}

EquilibriumReport DynamicAnalysis::start() {
    const EquilibriumReport report = solve_accelerations(system_, 0.0, workspace_, state_);
    if (!report.converged()) return report;
    integrator_->start(state_);
    system_.commit(state_, 0.0);
    ledger_ = std::make_unique<Ledger>(system_, *integrator_, state_);
    return report;
}

bool DynamicAnalysis::take_step(EquilibriumReport& report) {
    const Stage first_stage{0, control_.time(), control_.time_step(), control_.next_time()};
    const State last_accepted = state_;
    try {
        report = solve_step(system_, *integrator_, settings_.newton, first_stage, workspace_, state_);
    } catch (...) {
        state_ = last_accepted;
        throw;
    }
    if (!report.converged()) state_ = last_accepted;
    return report.converged();
}

EquilibriumReport DynamicAnalysis::advance() {
    EquilibriumReport report;
    solver_row_ = SolverRow{};
    while (!take_step(report)) {
        ++solver_row_.rejected_steps;
        if (!control_.reject()) return report;
    }
    ledger_->add_work(state_, control_.next_time(), workspace_.load_power, control_.time_step());
    solver_row_.time_step = control_.time_step();
    solver_row_.newton_iterations = report.iterations;
    solver_row_.residual = report.residual;
    const PhaseTimer timer(workspace_.seconds.update);
    system_.commit(state_, control_.next_time());
    control_.accept();
    return report;
}

Snapshot DynamicAnalysis::snapshot() {
    section_values_ = system_.compute_section_values(state_);
    system_.compute_residual(state_, state_.time, residual_);
    for (const auto& [node, component] : system_.equations().unknowns())
        residual_.nodal[node][component] = 0.0;
    return {state_.time, state_.trial, section_values_, residual_.nodal};
}

}  // namespace gxrod
