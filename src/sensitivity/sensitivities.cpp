#include "sensitivity/sensitivities.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <stdexcept>

#include "integrators/load_stepping.hpp"
#include "integrators/quasi_static.hpp"
#include "model/path_dependence.hpp"
#include "model/ties/ties.hpp"
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

// Friction of pairs, which come and go; obstacles have theirs in State::memory.
bool rub_on_each_other(const Contact& contact) {
    const auto rubs_there = [](const ContactException& one) { return one.friction.value_or(0.0) > 0.0; };
    return (contact.between_rods || contact.within_rods) &&
           (contact.friction > 0.0 || std::ranges::any_of(contact.exceptions, rubs_there));
}

// Speeds are of motions alone.
bool rubs_by_speed(const Model& model) {
    const Contact& contact = model.contact;
    const auto weakens = [](const auto& one) { return one.friction_shape.weakens(); };
    return model.has_inertia && model.has_time &&
           (weakens(contact) || std::ranges::any_of(contact.obstacles, weakens) ||
            std::ranges::any_of(contact.exceptions, weakens));
}

bool is_at_same_places(const State& a, const State& b) {
    constexpr double same = 1e-12;
    double size = 0.0, distance = 0.0, angle = 0.0;
    for (std::size_t i = 0; i < a.previous.size(); ++i) {
        size = std::max(size, a.previous[i].r.norm());
        distance = std::max(distance, (a.previous[i].r - b.previous[i].r).norm());
        angle = std::max(angle, a.previous[i].Lambda.angularDistance(b.previous[i].Lambda));
    }
    return distance <= same * size && angle <= 1e-7;
}

bool have_derivatives(const Model& model) {
    const auto has_them = [](const Section& section) {
        return !section.law || section.law->has_derivatives();
    };
    return std::ranges::all_of(model.sections, has_them) &&
           std::ranges::all_of(model.rods, [&](const Rod& rod) {
               return std::ranges::all_of(rod.varying.at_forces, has_them);
           });
}

}  // namespace

void Sensitivities::check_model(const Model& model) {
    if (has_breaking_joint(model))
        throw std::invalid_argument(
            "the time at which a joint breaks has no derivative here: take `breaks` out of the joints");
    if (!have_derivatives(model))
        throw std::invalid_argument(
            "there are no derivatives of ropes by the Syrope model yet: take a difference of whole runs");
    if (rub_on_each_other(model.contact))
        throw std::invalid_argument(
            "there are no derivatives of friction between rods and bodies that touch each other yet: take "
            "friction = 0 there, or a difference of whole runs");
    if (rubs_by_speed(model))
        throw std::invalid_argument(
            "there are no derivatives of friction that falls with the speed yet: take `kinetic` out of it, "
            "or a difference of whole runs");
}

void Sensitivities::check_settings(const AnalysisSettings& settings) {
    const std::unique_ptr<Integrator> integrator = make_step_integrator(settings);
    if (!integrator)
        throw std::invalid_argument("derivatives are there for static, quasi-static and dynamic analyses");
    if (integrator->conserves())
        throw std::invalid_argument(
            "derivatives are not carried along by energy-momentum: take integrator \"newmark-simplified\"");
}

Sensitivities::Sensitivities(const SteppedAnalysis& analysis,
                             const AnalysisSettings& settings,
                             const std::vector<VariedModels>& models)
    : analysis_(&analysis), integrator_(make_step_integrator(settings)) {
    check_settings(settings);
    check_model(analysis.system().model());
    if (const auto* statics = std::get_if<StaticSettings>(&settings)) linear_solver_ = statics->linear_solver;
    if (const auto* dynamic = std::get_if<DynamicSettings>(&settings)) {
        linear_solver_ = dynamic->linear_solver;
        projects_start_ = dynamic->projects_start;
        has_time_ = true;
    }
    follow(analysis);
    for (const VariedModels& varied : models)
        all_.emplace_back(analysis.system(), varied, integrator_->resolves_contact());
}

Sensitivities::~Sensitivities() = default;

void Sensitivities::follow(const SteppedAnalysis& analysis) {
    analysis_ = &analysis;
    step_ = std::make_unique<TangentLinearStep>(
        analysis.system(), *integrator_, analysis.newton(), linear_solver_);
}

StartOfAnalysis Sensitivities::find_start() const {
    return {*integrator_,
            {0.0, analysis_->steps().time_step()},
            step_->linear_solver(),
            projects_start_,
            has_time_ && analysis_->settled() != nullptr};
}

void Sensitivities::start() {
    for (ForwardSensitivity& one : all_) one.start(find_start());
    check_stops();
    if (analysis_->settled() == nullptr) return;
    State before = analysis_->system().initial_state();
    for (NodeMotion& motion : before.previous) {
        motion.v.setZero();
        motion.omega.setZero();
    }
    settle(before);
}

void Sensitivities::start_after(const Sensitivities& earlier) {
    const System& system = analysis_->system();
    if (earlier.have_ended()) {
        for (std::size_t i = 0; i < all_.size(); ++i) all_[i].end(earlier.by(i).kink());
        return;
    }
    // Velocities that fit at the end of a stage still do, to first order: a projection changes none of them.
    StartOfAnalysis start = find_start();
    start.projects = true;
    for (std::size_t i = 0; i < all_.size(); ++i) {
        all_[i].take_inputs(system.model());
        all_[i].start_after(earlier.before_, earlier.by(i).direction(), start);
        all_[i].end(earlier.by(i).kink());
    }
    check_stops();
    State before, ended;
    take_over_stage(system, earlier.before_, before);
    start_system(system, start, before, ended);
    if (analysis_->settled() != nullptr) {
        settle(before);
    } else if (!is_at_same_places(before, analysis_->state())) {
        for (ForwardSensitivity& one : all_)
            one.end(
                "it does not exist from the start of this stage on, where what acts at once was brought on "
                "in "
                "parts; let it grow over a time");
    }
    note_before();
}

// Equilibria find what holds in their first step.
void Sensitivities::check_stops() {
    const Model& model = analysis_->system().model();
    const HeldStops stops(model);
    if (integrator_->is_static() || !model.has_inertia) return;
    for (ForwardSensitivity& one : all_) {
        for (const VariedSystem* side : one.sides()) {
            if (!stops.are_equal(side->state.joints_previous, analysis_->state().joints_previous))
                one.end(
                    "it does not exist, because the number changes which joints are taut or at a stop at the "
                    "start: a kink");
        }
    }
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

bool Sensitivities::have_ended() const {
    return std::ranges::none_of(all_, [](const ForwardSensitivity& one) { return one.kink().empty(); });
}

void Sensitivities::advance() {
    if (have_ended()) return;
    try {
        take_step();
    } catch (const KinkError& error) {
        for (ForwardSensitivity& one : all_)
            one.end(fmt::format(
                "it does not exist from t = {:.6g} on, where {}", analysis_->state().time, error.what()));
    }
}

void Sensitivities::take_step() {
    const State& after = analysis_->state();
    for (ForwardSensitivity& one : all_) one.take_inputs(analysis_->system().model());
    if (inputs_ != nullptr) inputs_->act();
    if (analysis_->settled() != nullptr) {
        settle(before_);
        before_ = *analysis_->settled();
    }
    const Stage& stage = analysis_->last_stage();
    take_sides();
    for (ForwardSensitivity& one : all_) {
        one.check_smoothness(step_->centre().state, stage.time_step);
        if (!step_->has_reproduced(after))
            one.end(
                fmt::format("it does not exist from t = {:.6g} on, where energy was taken from velocities so "
                            "that contact "
                            "gains none; take shorter steps",
                            after.time));
    }
}

void Sensitivities::take_sides() {
    std::vector<StateDirection> starts;
    for (const ForwardSensitivity& one : all_) {
        if (inputs_ != nullptr) starts.push_back(one.direction());
    }
    while (true) {
        carry(before_, [&](std::span<VariedSystem* const> sides) {
            step_->advance(analysis_->last_stage(), before_, analysis_->state(), sides);
        });
        pieces_ = step_->pieces();
        for (ForwardSensitivity& one : all_) one.straighten_ends(step_->centre().ended);
        if (inputs_ == nullptr || !inputs_->follow()) return;
        for (std::size_t i = 0; i < all_.size(); ++i) all_[i].return_to(starts[i]);
    }
}

Sensitivities::Record Sensitivities::record() const {
    Record record{{}, pieces_, {}};
    if (inputs_ != nullptr) record.inputs = inputs_->record();
    for (const ForwardSensitivity& one : all_) record.all.push_back(one.record());
    return record;
}

void Sensitivities::recall(const Record& record) {
    pieces_ = record.pieces;
    for (std::size_t i = 0; i < all_.size(); ++i) {
        all_[i].recall(record.all.at(i), pieces_);
        all_[i].take_inputs(analysis_->system().model());
    }
    if (inputs_ != nullptr) inputs_->recall(record.inputs);
}

}  // namespace gxrod
