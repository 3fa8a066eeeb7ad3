#include "analyses/dynamic.hpp"

#include "analyses/start_velocities.hpp"
#include "integrators/quasi_static.hpp"
#include "model/newton_choice.hpp"

namespace gxrod {

std::unique_ptr<Integrator> make_scheme(const DynamicSettings& settings) {
    return settings.has_inertia ? make_integrator(settings) : std::make_unique<QuasiStatic>();
}

DynamicAnalysis::DynamicAnalysis(const Model& model, const DynamicSettings& settings, int threads)
    : SteppedAnalysis(model,
                      threads,
                      make_scheme(settings),
                      choose_newton(model, settings),
                      settings.linear_solver,
                      make_step_sequence(settings)),
      projects_start_(settings.projects_start) {}

EquilibriumReport DynamicAnalysis::start() {
    if (!system_.model().has_inertia) return start_at_rest();  // what creeps at once has no rate yet
    refuse_overlaps(0.0);
    const TimeSpan first_step{0.0, steps_->time_step()};
    fit_start_velocities(system_, 0.0, first_step, projects_start_, workspace_, state_);
    const EquilibriumReport report = solve_accelerations(system_, 0.0, first_step, workspace_, state_);
    if (report.converged()) accept_start();
    return report;
}

}  // namespace gxrod
