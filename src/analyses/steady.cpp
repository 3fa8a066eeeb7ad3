#include "analyses/steady.hpp"

#include <stdexcept>

#include "check/motions/turning_loads.hpp"
#include "integrators/steady_rotation.hpp"
#include "model/settings/newton_choice.hpp"
#include "solvers/steps/step_control.hpp"

namespace gxrod {

namespace {

constexpr int halvings = 30;  // as in statics

}  // namespace

SteadyAnalysis::SteadyAnalysis(const Model& model,
                               const StaticSettings& settings,
                               const TurningFrame& frame,
                               int threads)
    : SteppedAnalysis(model,
                      threads,
                      std::make_unique<SteadyRotation>(frame),
                      choose_newton(model, settings),
                      settings.linear_solver,
                      std::make_unique<StepControl>(1.0, settings.steps, halvings)),
      columns_(system_, frame) {
    const std::string cause = find_unsteady_action(model, frame);
    if (!cause.empty()) throw std::runtime_error(cause);
    workspace_.frame = &columns_;
}

EquilibriumReport SteadyAnalysis::start() {
    const TurningFrame& frame = columns_.frame();
    for (std::size_t i = 0; i < state_.trial.size(); ++i) set_steady_rates(frame, 0.0, i, state_.trial[i]);
    system_.compute_residual(state_, 0.0, workspace_.residual);
    accept_start();
    return {};
}

}  // namespace gxrod
