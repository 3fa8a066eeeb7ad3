#include "run/stepped_run.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <new>
#include <stdexcept>

#include "analyses/dynamic.hpp"
#include "assembly/system_measures.hpp"
#include "check/shape_report.hpp"
#include "machine/file_error.hpp"
#include "model/evaluation_error.hpp"
#include "model/settings/analysis_traits.hpp"
#include "model/settings/frame_interval.hpp"
#include "results/stresses/stress_table.hpp"
#include "watch/history_watch.hpp"
#include "watch/stress_words.hpp"

namespace gxrod {

SteppedRun::SteppedRun(RunRequest request)
    : request_(std::move(request)),
      books_(request_.problem.model, request_.examined),
      signals_(request_.problem),
      stages_(build()) {
    RunSummary& summary = books_.summary();
    summary.is_static = problem().record.is_static;
    summary.integrators = problem().record.integrators;
    if (request_.resumed) {
        resume();
    } else if (request_.results) {
        file_ = std::make_unique<ResultsFile>(
            *request_.results, problem().record, problem().model, problem().output);
    }
    if (file_) file_->write_outlines(problem().model, problem().outlines);
    schedule_output();
    note_interpolants();
    summary.nodes = static_cast<long>(problem().model.nodes.size());
    summary.elements = static_cast<long>(SystemMeasures(analysis().system()).count_elements());
    summary.unknowns = analysis().system().equations().count();
    summary.threads = analysis().system().team().size();
}

SteppedRun::~SteppedRun() = default;

StageSequence::Plan SteppedRun::make_plan() const {
    // Stresses of all rods are recorded in files alone.
    const bool has_file = request_.results || request_.resumed != nullptr;
    return {problem(),
            has_file ? list_recorded_places(problem().model, problem().output)
                     : list_rod_places(problem().output.histories),
            list_contact_watches(problem().output.histories),
            request_.threads};
}

std::unique_ptr<StageSequence> SteppedRun::build() {
    const PhaseTimer timer(setup_seconds_);
    if (request_.resumed == nullptr) return std::make_unique<StageSequence>(make_plan());
    const RestartRecord& record = request_.resumed->place().record;
    if (record.stage >= std::max<std::int64_t>(1, stage_count()))
        throw FileError(request_.resumed->path(),
                        "cannot be resumed: it is in a stage that the deck does not have");
    return std::make_unique<StageSequence>(make_plan(), record);
}

template <class Action>
bool SteppedRun::guard(const Action& action) {
    RunSummary& summary = books_.summary();
    try {
        if (action()) return true;
        books_.complete();
    } catch (const EvaluationError& error) {
        books_.fail(entering_ + error.what());
        summary.deck_fault = true;
    } catch (const FileError&) {
        phase_ = Phase::ended;
        throw;
    } catch (const std::bad_alloc&) {
        phase_ = Phase::ended;
        if (file_ && !file_->is_sound()) throw;
        books_.fail("out of memory");
        summary.out_of_memory = true;
    } catch (const std::exception& error) {
        books_.fail(entering_ + error.what());
    }
    phase_ = Phase::ended;
    return false;
}

bool SteppedRun::start() {
    if (phase_ != Phase::new_run) return phase_ != Phase::ended;
    return guard([&] {
        if (!request_.resumed && !take_first()) return false;
        phase_ = Phase::started;
        note_end();
        return true;
    });
}

bool SteppedRun::step() {
    if (phase_ == Phase::new_run && !start()) return false;
    if (phase_ == Phase::ended) return false;
    return guard([&] { return find_next_step(); });
}

// Through the ends of stages and paths; false at the end of the run, or if it failed.
bool SteppedRun::find_next_step() {
    while (true) {
        if (!has_steps(stages_->settings())) {
            if (!find_shapes() || !go_on()) return false;
            continue;
        }
        if (phase_ == Phase::started) begin_path();
        phase_ = Phase::stepping;
        if (!analysis().finished() && cause_.empty()) {
            if (!take_step()) return false;
            if (!cause_.empty()) continue;
            note_end();
            return true;
        }
        if (enter_next_branch()) continue;
        write_paths();
        if (!go_on()) return false;
    }
}

// Whether nothing can follow the last accepted step.
void SteppedRun::note_end() {
    if (stages_->is_last() && has_steps(stages_->settings()) && !is_path(stages_->settings()) &&
        analysis().finished()) {
        phase_ = Phase::ended;
        books_.complete();
    }
}

// Where the main path at hand begins.
void SteppedRun::begin_path() {
    if (!is_path(stages_->settings())) return;
    const bool has_start_row = stages_->index() == 0;
    stages_->begin_path(rows_ - analysis().steps().steps_done() - (has_start_row ? 1 : 0));
}

bool SteppedRun::enter_next_branch() {
    if (!is_path(stages_->settings())) return false;
    show_last();
    if (!stages_->enter_next_branch(cause_)) return false;
    cause_.clear();
    stages_->begin_path(rows_);
    books_.begin_branch(*stages_);
    return true;
}

// What the stage's path has found, if it is one that has not been written.
void SteppedRun::write_paths() {
    const PathRecord& paths = stages_->paths();
    if (paths.empty() || written_paths_ == stages_->moving_index() + 1) return;
    written_paths_ = stages_->moving_index() + 1;
    books_.add_paths(paths);
    if (!file_) return;
    const PhaseTimer timer(output_seconds_);
    file_->write_paths(place_of_stage(), problem().record, problem().model, paths);
}

bool SteppedRun::find_shapes() {
    const std::string prefix = name_stage(*stages_, stage_count());
    FoundShapes found = stages_->find_shapes();
    const std::string failure = find_failure(found.record);
    if (!failure.empty()) {
        books_.fail(prefix + failure);
        return false;
    }
    if (stages_->moving_index() == 0 && !has_steps(problem().analysis())) {
        const bool multiplies_loads = std::holds_alternative<BucklingRecord>(found.record);
        const std::string note = multiplies_loads ? "" : describe_left_out_loads(problem().model);
        if (!note.empty()) books_.summary().notes.push_back(prefix + note);
    }
    for (const std::string& note : note_sections(analysis().system(), analysis().state(), found.record))
        books_.summary().notes.push_back(prefix + note);
    for (const std::string& warning : warn_of_shapes(found.record)) books_.add_warning(prefix + warning);
    if (file_) {
        const PhaseTimer timer(output_seconds_);
        file_->write_shapes(
            place_of_stage(), problem().record, problem().model, analysis().state().previous, found.record);
    }
    books_.summary().shapes.push_back(std::move(found));
    return true;
}

// Enters the next stage; false if there is none, if the run is to stop here, or if the stage cannot start.
bool SteppedRun::go_on() {
    if (stages_->is_last()) return false;
    if (request_.until.empty() || stages_->name() != request_.until) return enter_next_stage();
    interrupt();
    books_.summary().stopped_as_asked = true;
    return false;
}

// False, and the reason is kept, if it cannot start.
bool SteppedRun::enter_next_stage() {
    phase_ = Phase::started;
    if (has_steps(problem().stages[stages_->index() + 1].analysis)) {
        for (const std::shared_ptr<Input>& input : problem().model.inputs) input->begin_stage();
    } else {
        stages_->enter_next();
        return true;
    }
    books_.sum_up_stage(*stages_, stage_count());
    entering_ = "stage " + stages_->name_of(stages_->index() + 1) + ": ";
    if (const std::optional<Failure> failure = stages_->enter_next()) {
        books_.fail(*failure, entering_);
        return false;
    }
    entering_.clear();
    const std::string& note = analysis().start_note();
    if (!note.empty()) books_.summary().notes.push_back("stage " + stages_->name() + ": " + note);
    books_.begin(*stages_);
    if (file_) file_->begin_stage(place_of_stage());
    const bool follows_time = !schedule_.is_empty();
    schedule_output();
    if (!follows_time && !schedule_.is_empty() && schedule_.list_start().is_sample)
        file_->record_sample(take_snapshot(false));
    if (request_.observe_stage) request_.observe_stage();
    return true;
}

StagePlace SteppedRun::place_of_stage() const {
    const std::string kind = kind_of(stages_->settings());
    return {stages_->index(), stages_->name().empty() ? kind : stages_->name(), kind, stages_->axis_start()};
}

void SteppedRun::explain_no_step(const std::filesystem::path& path, double time) const {
    const double end = end_of(stages_->settings());
    if (is_path(stages_->settings()))
        throw FileError(
            path, fmt::format("cannot be resumed: its arc length is {:.10g} already, after the end", time));
    if (time > end) {
        throw FileError(
            path,
            fmt::format(
                "cannot be resumed: it is at t = {:.10g} already, after the end, {:.10g}", time, end));
    }
    throw FileError(
        path,
        fmt::format("cannot be resumed: steps of {:.10g} do not meet t = {:.10g}, where it stopped",
                    analysis().steps().time_step(),
                    time),
        "take a step that goes into this time and into end_time, as that of the run does");
}

// False if no step of the stage can begin where the record stopped. Throws std::invalid_argument if it is of
// another model.
bool SteppedRun::take_over(const RestartRecord& record) {
    const std::vector<std::shared_ptr<Input>>& inputs = problem().model.inputs;
    if (record.inputs.size() != inputs.size())
        throw std::invalid_argument("the state to resume from is of a deck with other inputs");
    if (record.signals.size() != problem().signals.size())
        throw std::invalid_argument("the state to resume from is of a deck with other signals");
    for (std::size_t i = 0; i < inputs.size(); ++i) inputs[i]->recall(record.inputs[i]);
    signals_.recall(record.signals);
    if (!stages_->analysis().resume(record)) return false;
    recorded_time_ = record.axis_start + record.steps.time;
    books_.summary().totals = accepted_totals_ = record.totals;
    books_.begin(*stages_);
    has_started_ = true;
    last_framed_ = record.is_framed;
    return true;
}

void SteppedRun::resume() {
    const RestartRecord record = request_.resumed->place().record;
    const std::filesystem::path path = request_.resumed->path();
    bool has_step = false;
    try {
        has_step = take_over(record);
    } catch (const std::invalid_argument& error) {
        throw FileError(path, std::string("cannot be resumed: ") + error.what());
    }
    if (!has_step) explain_no_step(path, record.steps.time);
    rows_ = static_cast<std::int64_t>(request_.resumed->place().steps);
    file_ = std::make_unique<ResultsFile>(
        problem().record, problem().model, problem().output, std::move(*request_.resumed));
    file_->begin_stage(place_of_stage());
    request_.report_resumption(record);
}

RunCheckpoint SteppedRun::save() const {
    if (!has_started_) throw std::logic_error("the run has not started yet");
    if (stages_->has_critical_points())
        throw std::logic_error("a path cannot be saved after its first critical point");
    return {restart_record(), rows_};
}

void SteppedRun::restore(const RunCheckpoint& checkpoint) {
    if (file_) throw std::logic_error("a run that writes results cannot return to an earlier state");
    if (is_closed_) throw std::logic_error("the run is closed");
    if (checkpoint.record.stage >= std::max<std::int64_t>(1, stage_count()))
        throw std::invalid_argument("the state is of a deck with more stages");
    auto stages = std::make_unique<StageSequence>(make_plan(), checkpoint.record);
    std::swap(stages, stages_);
    try {
        if (!take_over(checkpoint.record))
            throw std::invalid_argument("no step of this deck can begin at the state's time");
    } catch (...) {
        std::swap(stages, stages_);
        throw;
    }
    books_.reopen();
    schedule_output();
    cause_.clear();
    rows_ = checkpoint.rows;
    phase_ = Phase::started;
    note_end();
}

bool SteppedRun::take_first() {
    const EquilibriumReport report = stages_->analysis().start();
    if (!report.converged()) {
        books_.fail(stages_->analysis().explain(report));
        return false;
    }
    const bool is_named = !problem().record.stages.empty() || is_path(problem().analysis());
    if (file_ && is_named) file_->begin_stage(place_of_stage());
    record();
    has_started_ = true;
    return true;
}

bool SteppedRun::take_step() {
    const bool can_be_last = file_ && is_path(stages_->settings()) && !stages_->has_critical_points();
    const std::optional<RestartRecord> before = can_be_last ? std::optional(restart_record()) : std::nullopt;
    set_signals();
    const EquilibriumReport report = stages_->analysis().advance();
    const SolverRow& row = analysis().solver_row();
    RunTotals& totals = books_.summary().totals;
    totals.rejected_steps += row.rejected_steps;
    if (!report.converged()) {
        const Failure failure = stages_->analysis().explain(report);
        if (stages_->branch() == 0) {
            books_.fail(failure);
            return false;
        }
        cause_ = describe_failure(failure);
        return true;
    }
    ++totals.steps;
    totals.newton_iterations += row.newton_iterations;
    stages_->note_row(rows_);
    // What a path has found is not kept: it is resumed before its first critical point.
    if (before && stages_->has_critical_points()) file_->set_restart(*before);
    record();
    const StepSequence& steps = analysis().steps();
    request_.report_progress({stages_->name(),
                              steps.steps_done(),
                              steps.steps_in_all(),
                              stages_->part_done(),
                              analysis().state().time,
                              row.time_step,
                              row.newton_iterations});
    return true;
}

void SteppedRun::set_signals() {
    if (is_timed(stages_->settings())) signals_.act(stages_->analysis(), stages_->axis_start());
}

RestartRecord SteppedRun::restart_record() const {
    RestartRecord record = analysis().restart_record();
    record.totals = accepted_totals_;
    record.is_framed = last_framed_;
    record.stage = static_cast<std::int64_t>(stages_->moving_index());
    record.axis_start = stages_->axis_start();
    record.stage_ends = stages_->ends();
    for (const std::shared_ptr<Input>& input : problem().model.inputs)
        record.inputs.push_back(input->state());
    record.signals = signals_.states();
    return record;
}

std::optional<double> SteppedRun::land_on(double time) {
    if (is_path(stages_->settings()) || !has_steps(stages_->settings())) return std::nullopt;
    const std::optional<double> landing = stages_->analysis().land_on(time - stages_->axis_start());
    return landing ? std::optional(stages_->axis_start() + *landing) : std::nullopt;
}

void SteppedRun::set_input(const std::string& name, double value, double until) {
    const auto& inputs = problem().model.inputs;
    const auto found = std::ranges::find(inputs, name, &Input::name);
    if (found == inputs.end()) throw std::invalid_argument("the deck has no input." + name);
    if ((*found)->is_signal())
        throw std::invalid_argument(fmt::format("{} is a signal, which the run itself sets", name));
    if (!std::isfinite(value)) throw std::invalid_argument(fmt::format("input.{} cannot be {}", name, value));
    (*found)->set(value, analysis().state().time, until - stages_->axis_start());
    analysis().system().forget_loads();
}

void SteppedRun::interrupt() {
    if (phase_ == Phase::ended) return;
    phase_ = Phase::ended;
    books_.summary().status = RunStatus::interrupted;
    books_.summary().reason = "interrupted at " + describe_place();
}

// Where the analysis is, as messages say it.
std::string SteppedRun::describe_place() const {
    if (!is_path(stages_->settings())) return fmt::format("t = {:.10g}", stages_->axis());
    const std::string place = fmt::format("λ = {:.10g}", analysis().state().time);
    return stages_->branch() == 0 ? place : place + " of " + stages_->paths().back().name;
}

void SteppedRun::close() {
    if (is_closed_) return;
    is_closed_ = true;
    interrupt();
    RunSummary& summary = books_.summary();
    summary.place = describe_place();
    leave_path();
    for (const std::string& warning : signals_.list_warnings()) books_.add_warning(warning);
    if (const StressTable* stresses = file_ ? file_->stresses() : nullptr) {
        StressWords words = describe_stresses(problem().model, stresses->watch(), stresses->envelope());
        summary.findings.insert(summary.findings.end(), words.findings.begin(), words.findings.end());
        for (std::string& warning : words.warnings) books_.add_warning(std::move(warning));
    }
    books_.close(*stages_, stage_count());
    if (file_) {
        const PhaseTimer timer(output_seconds_);
        write_end();
        file_->close(summary.status, summary.reason, summary.reason_nodes, books_.join_warnings());
        file_.reset();
    }
    summary.time = recorded_time_;
    summary.phases = stages_->seconds();
    summary.phases.setup = setup_seconds_;
    summary.phases.output = output_seconds_;
}

// Of a run that ended on it.
void SteppedRun::leave_path() {
    if (!is_path(stages_->settings())) return;
    if (stages_->branch() > 0 && (!file_ || file_->is_sound())) show_last();
    stages_->leave_branches();
    if (!file_ || file_->is_sound()) write_paths();
}

}  // namespace gxrod
