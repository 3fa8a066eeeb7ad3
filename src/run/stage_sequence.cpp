#include "run/stage_sequence.hpp"

#include <algorithm>
#include <cmath>

#include "analyses/shapes/buckling.hpp"
#include "analyses/shapes/eigenvalues.hpp"
#include "analyses/shapes/gravity_excitation.hpp"
#include "analyses/shapes/modes.hpp"
#include "analyses/shapes/response.hpp"
#include "assembly/touching_system.hpp"
#include "model/settings/analysis_traits.hpp"
#include "run/swept_equilibria.hpp"

namespace gxrod {
namespace {

ComplexVectors sum_up(const std::vector<Excitation>& excitation, std::size_t nodes) {
    ComplexVectors sum{std::vector<Vec6>(nodes, Vec6::Zero()), std::vector<Vec6>(nodes, Vec6::Zero())};
    for (const Excitation& one : excitation) {
        Vec6 load;
        load << one.force, one.moment;
        sum.real[one.node] += std::cos(one.phase) * load;
        sum.imaginary[one.node] += std::sin(one.phase) * load;
    }
    return sum;
}

}  // namespace

StageSequence::StageSequence(Plan plan)
    : plan_(std::move(plan)), axis_start_(find_axis_start(plan_.problem.stages)), current_(build(0)) {
    prepare_path();
}

StageSequence::StageSequence(Plan plan, const RestartRecord& record)
    : plan_(restore_ends(std::move(plan), record)),
      index_(static_cast<std::size_t>(record.stage)),
      moving_index_(index_),
      axis_start_(record.axis_start),
      current_(build(index_)) {
    prepare_path();
}

StageSequence::Plan StageSequence::restore_ends(Plan plan, const RestartRecord& record) {
    for (std::size_t i = 0; i < std::min(plan.problem.stages.size(), record.stage_ends.size()); ++i) {
        if (plan.problem.stages[i].end) *plan.problem.stages[i].end = record.stage_ends[i];
    }
    return plan;
}

std::vector<double> StageSequence::ends() const {
    std::vector<double> ends;
    for (const StagePlan& stage : plan_.problem.stages) ends.push_back(stage.end ? *stage.end : 0.0);
    return ends;
}

void StageSequence::prepare_path() {
    follower_.reset();
    axis_end_.reset();
    const auto* path = std::get_if<PathSettings>(&settings());
    if (path != nullptr) follower_.emplace(*path, name().empty() ? "path" : name());
}

const PathRecord& StageSequence::paths() const {
    static const PathRecord none;
    return follower_ ? follower_->record() : none;
}

void StageSequence::begin_path(std::int64_t row) {
    if (follower_) follower_->begin(row);
}

void StageSequence::note_row(std::int64_t row) {
    if (follower_ && !axis_end_) follower_->note(static_cast<const PathAnalysis&>(analysis()), row);
}

void StageSequence::end_path(const std::string& cause) {
    if (!follower_ || axis_end_) return;
    follower_->end(static_cast<const PathAnalysis&>(analysis()), cause);
    if (branch_) seconds_ += branch_->seconds();
}

bool StageSequence::enter_next_branch(const std::string& cause) {
    if (!follower_ || axis_end_) return false;
    end_path(cause);
    const double here = axis();
    const std::optional<BranchStart> start = follower_->enter_next();
    if (!start) {
        branch_.reset();
        axis_end_ = here;
        return false;
    }
    branch_start_ = here;
    branch_ = std::make_unique<PathAnalysis>(model(), std::get<PathSettings>(settings()), plan_.threads);
    branch_->watch(plan_.watched, plan_.watched_contacts);
    branch_->start(*start);
    return true;
}

void StageSequence::leave_branches() {
    if (!follower_ || axis_end_) return;
    const double here = axis();
    end_path("");
    branch_.reset();
    axis_end_ = here;
}

const AnalysisSettings& StageSequence::settings() const { return settings_of(index_); }

FoundShapes StageSequence::find_shapes() const {
    const std::string stage = name().empty() ? kind_of(settings()) : name();
    // After a quasi-static stage, whose system has none.
    std::optional<Model> with_inertia;
    std::optional<System> own_system;
    if (!model().has_inertia) {
        with_inertia.emplace(model()).has_inertia = true;
        own_system.emplace(*with_inertia, analysis().system().team());
    }
    State accepted = analysis().state();
    undo_trial(accepted);
    const TouchingSystem touching(own_system ? *own_system : analysis().system(), accepted);
    const System& system = touching.system();
    const State& state = touching.state();
    if (const auto* modes = std::get_if<ModesSettings>(&settings()))
        return {stage, find_modes(system, state, state.time, *modes)};
    if (const auto* response = std::get_if<ResponseSettings>(&settings())) {
        return {stage, find_response_of(system, state, *response)};
    }
    const auto* eigenvalues = std::get_if<EigenvalueSettings>(&settings());
    if (eigenvalues != nullptr && eigenvalues->sweep) return {stage, find_sweep(*eigenvalues)};
    if (eigenvalues != nullptr)
        return {stage, find_eigenvalues(system, state, state.time, *eigenvalues, analysis().frame())};
    const double load_time = moving_index_ == 0 && !has_steps(plan_.problem.analysis()) ? 1.0 : state.time;
    return {stage, find_buckling(system, state, load_time, std::get<BucklingSettings>(settings()))};
}

ResponseRecord StageSequence::find_response_of(const System& system,
                                               const State& state,
                                               const ResponseSettings& settings) const {
    const FrameColumns* frame = analysis().frame();
    std::vector<double> omegas = settings.omegas;
    ComplexVectors excitation = sum_up(settings.excitation, state.trial.size());
    if (settings.gravity && frame != nullptr) {
        RevolvingLoad load =
            compute_gravity_excitation(system, state, state.time, frame->frame(), *settings.gravity);
        omegas = {load.omega};
        excitation = std::move(load.forces);
    }
    ResponseRecord found = find_response(system, state, state.time, omegas, excitation, frame);
    found.points = settings.points;
    return found;
}

SweepRecord StageSequence::find_sweep(const EigenvalueSettings& settings) const {
    SweptEquilibria equilibria(plan_.problem.stages[index_], index_, plan_.threads);
    SweepSettings sweep{.eigenvalues = settings,
                        .finds_onset = settings.sweep->finds_onset,
                        .keeps_shapes = settings.sweep->keeps_shapes};
    sweep.eigenvalues.counts = false;
    SweepRecord record = sweep_eigenvalues(
        settings.sweep->values, [&](double value) { return equilibria.find(value); }, sweep);
    record.key = settings.sweep->key;
    return record;
}

StageSequence::Current StageSequence::build(std::size_t stage) const {
    Current current;
    if (stage > 0) {
        current.model = std::make_unique<Model>(plan_.problem.model);
        set_actions(plan_.problem.stages[stage].actions, *current.model);
    }
    current.analysis = make_analysis(
        current.model ? *current.model : plan_.problem.model, settings_of(stage), plan_.threads);
    current.analysis->watch(plan_.watched, plan_.watched_contacts);
    return current;
}

double StageSequence::part_done() const {
    const auto count = static_cast<double>(std::max<std::size_t>(plan_.problem.stages.size(), 1));
    const double part = has_steps(settings()) && !axis_end_ ? analysis().steps().part_done() : 0.0;
    return (static_cast<double>(index_) + part) / count;
}

std::optional<Failure> StageSequence::enter_next() {
    const std::size_t next = index_ + 1;
    if (!has_steps(plan_.problem.stages[next].analysis)) {
        index_ = next;
        return std::nullopt;
    }
    // What acted on a path keeps the size that it had at its end.
    const StagePlan& ended = plan_.problem.stages[moving_index_];
    if (is_path(ended.analysis) && ended.end) *ended.end = analysis().state().time;
    Current current = build(next);
    const EquilibriumReport report = current.analysis->start_after(*current_.analysis);
    if (!report.converged()) return current.analysis->explain(report);
    warnings_ = list_warnings();
    seconds_ = seconds();
    was_unstable_ = is_unstable();
    axis_start_ = axis();
    branch_start_.reset();
    moving_index_ = index_ = next;
    std::swap(current_, current);
    prepare_path();
    return std::nullopt;
}

PhaseSeconds StageSequence::seconds() const {
    PhaseSeconds sum = seconds_;
    sum += analysis().seconds();
    return sum;
}

std::vector<std::string> StageSequence::list_warnings() const {
    std::vector<std::string> warnings = warnings_;
    for (const std::string& warning : analysis().list_warnings()) warnings.push_back(prefix() + warning);
    return warnings;
}

}  // namespace gxrod
