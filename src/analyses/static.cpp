#include "analyses/static.hpp"

#include "analyses/dynamic.hpp"
#include "integrators/load_stepping.hpp"
#include "model/newton_choice.hpp"
#include "solvers/step_control.hpp"

namespace gxrod {

namespace {

// A slack cable carries the first of its load by stretching hardly at all: its first step may have to be
// a billionth of the others.
constexpr int halvings = 30;

}  // namespace

StaticAnalysis::StaticAnalysis(const Model& model, const StaticSettings& settings, int threads)
    : SteppedAnalysis(model,
                      threads,
                      std::make_unique<LoadStepping>(),
                      choose_newton(model, settings),
                      settings.linear_solver,
                      std::make_unique<StepControl>(1.0, settings.steps, halvings)) {}

EquilibriumReport StaticAnalysis::start() {
    for (NodeMotion& motion : state_.trial) {
        motion.v.setZero();
        motion.omega.setZero();
    }
    system_.compute_residual(state_, 0.0, workspace_.residual);
    accept_start();
    return {};
}

std::unique_ptr<SteppedAnalysis> make_analysis(const Model& model,
                                               const AnalysisSettings& settings,
                                               int threads) {
    if (const auto* dynamic = std::get_if<DynamicSettings>(&settings)) {
        return std::make_unique<DynamicAnalysis>(model, *dynamic, threads);
    }
    return std::make_unique<StaticAnalysis>(model, std::get<StaticSettings>(settings), threads);
}

}  // namespace gxrod
