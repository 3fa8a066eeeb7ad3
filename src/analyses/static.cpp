#include "analyses/static.hpp"

#include "analyses/dynamic.hpp"
#include "analyses/path/path.hpp"
#include "analyses/steady.hpp"
#include "integrators/load_stepping.hpp"
#include "model/newton_choice.hpp"
#include "solvers/paired_matrix.hpp"
#include "solvers/step_control.hpp"

namespace gxrod {

namespace {

// A slack cable carries the first of its load by stretching hardly at all: its first step may have to be
// a billionth of the others.
constexpr int halvings = 30;

// Of a nominal step, down to which a stable equilibrium is sought, and how many times in a run: a shape that
// wrinkles all the way is not to take sixteen times as many steps.
constexpr double finest_part = 1.0 / 256.0;
constexpr int most_sought = 5;

}  // namespace

StaticAnalysis::StaticAnalysis(const Model& model, const StaticSettings& settings, int threads)
    : SteppedAnalysis(model,
                      threads,
                      std::make_unique<LoadStepping>(),
                      choose_newton(model, settings),
                      settings.linear_solver,
                      std::make_unique<StepControl>(1.0, settings.steps, halvings)),
      nominal_step_(1.0 / static_cast<double>(settings.steps)),
      counter_(system_),
      has_potential_(find_load_without_potential(model).empty()),
      trial_(has_contrast_ ? -1 : 0),
      accepted_(trial_) {}

EquilibriumReport StaticAnalysis::start() { return start_at_rest(); }

Stage StaticAnalysis::current_stage() const {
    return {0, steps_->time(), steps_->time_step(), steps_->next_time()};
}

void StaticAnalysis::judge_equilibrium(EquilibriumReport& report) {
    if (workspace_.paired && workspace_.paired->is_iterative()) accepted_ = -1;
    if (accepted_ < 0) {
        trial_ = accepted_;
        return;
    }
    const bool is_last = steps_->next_time() >= 1.0;
    const auto as_known = [&](std::int64_t count) { return has_potential_ || count < 0 ? count : count % 2; };
    trial_ = as_known(report.negative_pivots);
    // The last factorization was of the iterate before, of the mixed tangent mostly, whose resultants are
    // those of the last load step at first: after few iterations it says nothing of this one.
    constexpr int few = 2;
    if (is_last || trial_ != accepted_ || report.iterations <= few) {
        trial_ = as_known(counter_.count(*integrator_, current_stage(), workspace_, state_));
    }
    is_counted_ = trial_ >= 0;
    if (!is_counted_) trial_ = accepted_;
    // What contact holds may leave a stable branch that ends for one that goes on in a longer step alone.
    const bool can_seek = !system_.contact() && sought_ < most_sought &&
                          steps_->time_step() > nominal_step_ * finest_part * (1.0 + 1e-9);
    if (trial_ > accepted_ && can_seek) report.outcome = Outcome::lost_stability;
}

void StaticAnalysis::note_equilibrium() {
    if (trial_ == accepted_) return;
    StabilityChange change{steps_->time(), steps_->next_time(), accepted_, trial_, ""};
    if (trial_ > accepted_) {
        change.shape = counter_.describe_shape(*integrator_, current_stage(), workspace_, state_);
        was_unstable_ = true;
        ++sought_;
    }
    changes_.push_back(std::move(change));
    accepted_ = trial_;
}

bool StaticAnalysis::is_unstable() const { return was_unstable_ || accepted_ > 0; }

std::vector<std::string> StaticAnalysis::list_warnings() const {
    return describe_stability(changes_, accepted_, state_.time, has_potential_, system_.contact() != nullptr);
}

std::unique_ptr<SteppedAnalysis> make_analysis(const Model& model,
                                               const AnalysisSettings& settings,
                                               int threads) {
    if (const auto* dynamic = std::get_if<DynamicSettings>(&settings)) {
        return std::make_unique<DynamicAnalysis>(model, *dynamic, threads);
    }
    if (const auto* path = std::get_if<PathSettings>(&settings)) {
        return std::make_unique<PathAnalysis>(model, *path, threads);
    }
    if (const auto* steady = std::get_if<SteadySettings>(&settings)) {
        return std::make_unique<SteadyAnalysis>(model, *steady, *model.rotation, threads);
    }
    // What finds shapes finds them about the state of an equilibrium.
    const auto* statics = std::get_if<StaticSettings>(&settings);
    return std::make_unique<StaticAnalysis>(model, statics != nullptr ? *statics : StaticSettings{}, threads);
}

}  // namespace gxrod
