#include "analyses/dynamic.hpp"

namespace gxrod {

DynamicAnalysis::DynamicAnalysis(const Model& model, const DynamicSettings& settings)
    : SteppedAnalysis(model,
                      make_integrator(settings),
                      settings.newton,
                      settings.linear_solver,
                      make_step_sequence(settings)) {}

EquilibriumReport DynamicAnalysis::start() {
    const SupportDifferences differences{support_difference * steps_->time_step(), Supports::Side::after};
    const EquilibriumReport report = solve_accelerations(system_, 0.0, differences, workspace_, state_);
    if (report.converged()) accept_start();
    return report;
}

}  // namespace gxrod
