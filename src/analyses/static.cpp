#include "analyses/static.hpp"

#include <fmt/format.h>
#include "analyses/dynamic.hpp"
#include "analyses/path/path.hpp"
#include "analyses/steady.hpp"
#include "assembly/contact/contacts.hpp"
#include "integrators/load_stepping.hpp"

#include "model/settings/newton_choice.hpp"
#include "solvers/divergence.hpp"
#include "solvers/paired_matrix.hpp"
#include "solvers/relaxation.hpp"
#include "solvers/steps/step_control.hpp"

namespace gxrod {

namespace {

// A slack cable carries the first of its load by stretching hardly at all: its first step may have to be
// a billionth of the others.
constexpr int halvings = 30;

// Of a nominal step, down to which a stable equilibrium is sought, and how many times in a run: a shape that
// wrinkles all the way is not to take sixteen times as many steps.
constexpr double finest_part = 1.0 / 256.0;
constexpr int most_sought = 5;

// Of the stiffness of loads: a shape that grows more slowly in pseudo-time is neutral; and the stiffness
// below which a shape is loose.
constexpr double least_rate = 1e-4;
constexpr double loose = 1e-3;

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

bool StaticAnalysis::may_relax() const {
    const bool is_counted = accepted_ >= 0 && has_potential_;
    const bool is_first = steps_->time() == 0.0 || (!is_counted && steps_->time() < nominal_step_);
    return !gave_up_ && !Contacts(system_).are_possible() && is_first;
}

bool StaticAnalysis::diverges() {
    const double time = steps_->next_time();
    const double stiffness = measure_load_stiffness(system_, time, workspace_, state_);
    return find_divergence(system_, time, PseudoDrag(system_), least_rate * stiffness, state_).has_value();
}

bool StaticAnalysis::starts_loose() {
    const double stiffness = measure_load_stiffness(system_, steps_->next_time(), workspace_, state_);
    State start = state_;
    undo_trial(start);
    return is_softer_than(loose * stiffness, system_, start.time, PseudoDrag(system_), start);
}

EquilibriumReport StaticAnalysis::solve_trial() {
    if (!relaxes_) return SteppedAnalysis::solve_trial();
    const RelaxationReport found = relax(system_, *integrator_, newton_, current_stage(), workspace_, state_);
    pseudo_steps_ = found.pseudo_steps;
    return found.equilibrium;
}

bool StaticAnalysis::tries_otherwise(const EquilibriumReport&, bool is_shortest) {
    if (relaxes_) {
        relaxes_ = false;
        gave_up_ = true;
        findings_.push_back(fmt::format("relaxation found no equilibrium at t = {:.10g} in {} pseudo-steps",
                                        steps_->next_time(),
                                        pseudo_steps_));
        return wants_to_relax_;
    }
    // Where round-off hides what is soft, it fails steps, and would drive a relaxation, too.
    if (!may_relax() || !(wants_to_relax_ || (is_shortest && !has_contrast_))) return false;
    relaxes_ = true;
    steps_->resume(steps_->memory());  // with the longest step from here again
    return true;
}

void StaticAnalysis::judge_equilibrium(EquilibriumReport& report) {
    if (workspace_.paired && workspace_.paired->is_iterative()) accepted_ = -1;
    const bool is_last = steps_->next_time() >= 1.0;
    if (accepted_ < 0) {
        trial_ = accepted_;
    } else {
        const auto as_known = [&](std::int64_t count) {
            return has_potential_ || count < 0 ? count : count % 2;
        };
        trial_ = as_known(report.negative_pivots);
        // The last factorization was of the iterate before, of the mixed tangent mostly, whose resultants are
        // those of the last load step at first: after few iterations it says nothing of this one.
        constexpr int few = 2;
        if (is_last || trial_ != accepted_ || report.iterations <= few) {
            trial_ = as_known(counter_.count(*integrator_, current_stage(), workspace_, state_));
        }
        is_counted_ = trial_ >= 0;
        if (!is_counted_) trial_ = accepted_;
    }
    if (relaxes_) return;
    const bool is_counted = accepted_ >= 0 && has_potential_;
    const bool is_asked =
        !is_counted && trial_ <= accepted_ && !Contacts(system_).are_possible() && (is_last || may_relax());
    const bool leaves = is_asked && diverges();
    if (!leaves && trial_ <= accepted_) return;
    // What contact holds may leave a stable branch that ends for one that goes on in a longer step alone.
    // A later state does not tell: close to a critical point every structure is soft.
    const bool is_at_start = steps_->time() == 0.0;
    const bool is_loose = is_at_start && may_relax() && !is_counted && starts_loose();
    const bool can_seek = (trial_ > accepted_ || is_loose) && !Contacts(system_).are_possible() &&
                          sought_ < most_sought &&
                          steps_->time_step() > nominal_step_ * finest_part * (1.0 + 1e-9);
    wants_to_relax_ = is_loose || (is_counted && may_relax() && !can_seek);
    if (can_seek || wants_to_relax_) {
        report.outcome = Outcome::lost_stability;
    } else if (leaves && is_last && trial_ <= 0) {
        leaving_shape_ = counter_.describe_shape(*integrator_, current_stage(), workspace_, state_);
    }
}

void StaticAnalysis::note_equilibrium() {
    if (relaxes_) {
        relaxes_ = false;
        findings_.push_back(
            fmt::format("statics relaxed to the equilibrium at t = {:.10g} in {} pseudo-steps",
                        steps_->next_time(),
                        pseudo_steps_));
    }
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

bool StaticAnalysis::is_unstable() const { return was_unstable_ || accepted_ > 0 || !leaving_shape_.empty(); }

std::vector<std::string> StaticAnalysis::list_warnings() const {
    std::vector<std::string> warnings = describe_stability(
        changes_, accepted_, state_.time, has_potential_, Contacts(system_).are_possible());
    if (!leaving_shape_.empty()) {
        warnings.push_back(fmt::format(
            "the state at t = {:.10g} is unstable, though the determinant of the tangent does not show it: a "
            "structure leaves it at a touch. The shape that gives way: {}",
            state_.time,
            leaving_shape_));
    }
    return warnings;
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
