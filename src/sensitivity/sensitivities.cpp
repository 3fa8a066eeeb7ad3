#include "sensitivity/sensitivities.hpp"

#include <fmt/format.h>

#include <stdexcept>

#include "assembly/contact/contacts.hpp"
#include "integrators/load_stepping.hpp"
#include "integrators/quasi_static.hpp"
#include "model/path_dependence.hpp"
#include "sensitivity/sensitivity_error.hpp"

namespace gxrod {

namespace {

// nullptr for an analysis whose steps are not differentiated.
std::unique_ptr<Integrator> make_step_integrator(const AnalysisSettings& settings) {
    if (std::holds_alternative<StaticSettings>(settings)) return std::make_unique<LoadStepping>();
    const auto* dynamic = std::get_if<DynamicSettings>(&settings);
    if (dynamic == nullptr) return nullptr;
    if (!dynamic->has_inertia) return std::make_unique<QuasiStatic>();
    return make_integrator(*dynamic);
}

}  // namespace

Sensitivities::Sensitivities(const SteppedAnalysis& analysis,
                             const AnalysisSettings& settings,
                             const std::vector<VariedModels>& models)
    : analysis_(&analysis), integrator_(make_step_integrator(settings)) {
    if (!integrator_)
        throw std::invalid_argument("derivatives are there for static, quasi-static and dynamic analyses");
    if (integrator_->coupled() != nullptr)
        throw std::invalid_argument(
            "derivatives are not carried along by schemes that find the stages of a step together: take "
            "integrator \"sdirk-4\"");
    if (integrator_->conserves())
        throw std::invalid_argument(
            "derivatives are not carried along by energy-momentum: take integrator \"newmark-simplified\"");
    if (Contacts(analysis.system()).are_possible())
        throw std::invalid_argument("there are no derivatives with contact yet");
    if (const auto* statics = std::get_if<StaticSettings>(&settings)) linear_solver_ = statics->linear_solver;
    if (const auto* dynamic = std::get_if<DynamicSettings>(&settings)) {
        linear_solver_ = dynamic->linear_solver;
        projects_start_ = dynamic->projects_start;
    }
    follow(analysis);
    for (const VariedModels& varied : models) all_.emplace_back(analysis.system(), varied);
}

Sensitivities::~Sensitivities() = default;

void Sensitivities::follow(const SteppedAnalysis& analysis) {
    analysis_ = &analysis;
    step_ = std::make_unique<TangentLinearStep>(
        analysis.system(), *integrator_, analysis.newton(), linear_solver_);
}

void Sensitivities::start() {
    const TimeSpan first_step{0.0, analysis_->steps().time_step()};
    for (ForwardSensitivity& one : all_)
        one.start(*integrator_,
                  first_step,
                  step_->linear_solver(),
                  projects_start_,
                  analysis_->settled() != nullptr);
    if (analysis_->settled() == nullptr) return;
    State before = analysis_->system().initial_state();
    for (NodeMotion& motion : before.previous) {
        motion.v.setZero();
        motion.omega.setZero();
    }
    settle(before);
}

void Sensitivities::settle(const State& before) {
    const State& after = *analysis_->settled();
    const Stage& stage = analysis_->settled_stage();
    if (analysis_->settled_parts() > 1 && depends_on_path(analysis_->system().model())) {
        throw SensitivityError(fmt::format(
            "the derivative of what acts at once at t = {:.6g} cannot be found: it was brought on in {} "
            "parts, on "
            "which what slips or yields depends; let it grow over a time, or take a difference of whole runs",
            stage.step_time,
            analysis_->settled_parts()));
    }
    TangentLinearStep settling(
        analysis_->system(), analysis_->settling_integrator(), analysis_->newton(), linear_solver_);
    carry(before,
          [&](std::span<VariedSystem* const> sides) { settling.settle(stage, before, after, sides); });
}

template <class Take>
void Sensitivities::carry(const State& before, const Take& take) {
    std::vector<VariedSystem*> sides;
    for (ForwardSensitivity& one : all_) {
        one.place_sides(before);
        for (VariedSystem* side : one.sides()) sides.push_back(side);
    }
    take(sides);
    for (ForwardSensitivity& one : all_) one.take_sides();
}

void Sensitivities::advance() {
    const State& after = analysis_->state();
    for (ForwardSensitivity& one : all_) one.take_inputs(analysis_->system().model());
    if (analysis_->settled() != nullptr) {
        settle(before_);
        before_ = *analysis_->settled();
    }
    const Stage& stage = analysis_->last_stage();
    carry(before_,
          [&](std::span<VariedSystem* const> sides) { step_->advance(stage, before_, after, sides); });
    pieces_ = step_->pieces();
    for (ForwardSensitivity& one : all_) {
        one.straighten_ends(step_->centre().ended);
        one.check_smoothness(step_->centre().state, stage.time_step);
    }
}

Sensitivities::Record Sensitivities::record() const {
    Record record{{}, pieces_};
    for (const ForwardSensitivity& one : all_) record.all.push_back(one.record());
    return record;
}

void Sensitivities::recall(const Record& record) {
    pieces_ = record.pieces;
    for (std::size_t i = 0; i < all_.size(); ++i) all_[i].recall(record.all.at(i), pieces_);
}

}  // namespace gxrod
