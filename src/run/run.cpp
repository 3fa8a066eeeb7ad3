#include "run/run.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <new>

#include "check/shape_report.hpp"
#include "machine/file_error.hpp"
#include "model/analysis_traits.hpp"
#include "model/evaluation_error.hpp"
#include "model/frame_interval.hpp"
#include "model/newton_choice.hpp"
#include "results/tables/history_point.hpp"

namespace gxrod {

namespace {

class Run {
  public:
    explicit Run(const RunRequest& request) : request_(request), stages_(build(request, setup_seconds_)) {
        summary_.is_static = request.deck.is_static;
        if (request.resumed) {
            resume();
        } else if (request.results) {
            file_ =
                std::make_unique<ResultsFile>(*request.results, request.deck, request.model, request.output);
        }
        summary_.nodes = static_cast<long>(request.model.nodes.size());
        summary_.elements = static_cast<long>(analysis().system().element_count());
        summary_.unknowns = analysis().system().equations().count();
        summary_.threads = analysis().system().team().size();
    }

    void run() {
        try {
            if (start()) {
                while (run_stage() && !stages_->is_last() && enter_next_stage()) {
                }
            }
        } catch (const EvaluationError& error) {
            fail(error.what());
            summary_.deck_fault = true;
        } catch (const FileError&) {
            throw;
        } catch (const std::bad_alloc&) {
            if (file_ && !file_->is_sound()) throw;
            fail("out of memory");
            summary_.out_of_memory = true;
        } catch (const std::exception& error) {
            fail(error.what());
        }
        close();
    }

    RunSummary summary() const { return summary_; }

  private:
    static std::unique_ptr<StageSequence> build(const RunRequest& request, double& seconds) {
        const PhaseTimer timer(seconds);
        StageSequence::Plan plan{request.model,
                                 request.analysis,
                                 request.stages,
                                 list_rod_places(request.output.histories),
                                 request.threads};
        if (request.resumed == nullptr) return std::make_unique<StageSequence>(std::move(plan));
        const RestartRecord& record = request.resumed->place().record;
        const auto count = std::max<std::int64_t>(1, static_cast<std::int64_t>(request.stages.size()));
        if (record.stage >= count)
            throw FileError(request.resumed->path(),
                            "cannot be resumed: it is in a stage that the deck does not have");
        return std::make_unique<StageSequence>(std::move(plan), record);
    }

    SteppedAnalysis& analysis() { return stages_->analysis(); }
    const SteppedAnalysis& analysis() const { return stages_->analysis(); }
    long frame_interval() const {
        return stages_->index() == 0 ? request_.output.every
                                     : request_.stages[stages_->index()].frame_interval;
    }

    // To the end of the stage; false if that was not reached.
    bool run_stage() {
        if (!has_steps(stages_->settings())) return find_shapes();

        begin_path();
        std::string cause;  // why a branch was given up
        do {
            while (!analysis().finished() && cause.empty()) {
                if (interrupted() || !step(cause)) return false;
            }
        } while (enter_next_branch(cause));
        write_paths();
        return true;
    }

    // Where the main path at hand begins.
    void begin_path() {
        if (!is_path(stages_->settings())) return;
        const bool has_start_row = stages_->index() == 0;
        stages_->begin_path(rows_ - analysis().steps().steps_done() - (has_start_row ? 1 : 0));
    }

    bool enter_next_branch(std::string& cause) {
        if (!is_path(stages_->settings())) return false;
        show_last();
        if (!stages_->enter_next_branch(cause)) return false;
        cause.clear();
        stages_->begin_path(rows_);
        last_point_ = point_of(analysis().ledger_row());
        return true;
    }

    // Frames show where a path that was given up ends, too.
    void show_last() {
        if (!file_ || last_framed_ || !has_started_) return;
        file_->write_frame(take_snapshot());
        last_framed_ = true;
    }

    // What the stage's path has found, if it is one that has not been written.
    void write_paths() {
        const PathRecord& paths = stages_->paths();
        if (paths.empty() || written_paths_ == stages_->moving_index() + 1) return;
        written_paths_ = stages_->moving_index() + 1;
        summary_.paths.push_back(paths);
        for (const FollowedPath& path : paths) {
            for (const std::string& finding : path.findings)
                summary_.findings.push_back(path.name + ": " + finding);
            if (!path.cause.empty()) shape_warnings_.push_back(path.name + " was given up: " + path.cause);
        }
        if (!file_) return;
        const PhaseTimer timer(output_seconds_);
        file_->write_paths(place_of_stage(), request_.deck, request_.model, paths);
    }

    bool find_shapes() {
        FoundShapes found = stages_->find_shapes();
        const std::string failure = find_failure(found.record);
        if (!failure.empty()) {
            fail(name_stage() + failure);
            return false;
        }
        if (stages_->moving_index() == 0 && !has_steps(request_.analysis)) {
            const bool multiplies_loads = std::holds_alternative<BucklingRecord>(found.record);
            const std::string note = multiplies_loads ? "" : describe_left_out_loads(request_.model);
            if (!note.empty()) summary_.notes.push_back(name_stage() + note);
        }
        for (const std::string& warning : warn_of_shapes(found.record))
            shape_warnings_.push_back(name_stage() + warning);
        if (file_) {
            const PhaseTimer timer(output_seconds_);
            file_->write_shapes(
                place_of_stage(), request_.deck, request_.model, analysis().state().previous, found.record);
        }
        summary_.shapes.push_back(std::move(found));
        return true;
    }

    // Before a sentence about the stage at hand.
    std::string name_stage() const {
        return request_.stages.size() > 1 ? "stage " + stages_->name() + ": " : "";
    }

    // False, and the reason is kept, if it cannot start.
    bool enter_next_stage() {
        if (!has_steps(request_.stages[stages_->index() + 1].analysis)) {
            stages_->enter_next();
            return true;
        }
        sum_up_cuts();
        compare_errors();
        const EquilibriumReport report = stages_->enter_next();
        if (!report.converged()) {
            fail(analysis().explain(report));
            return false;
        }
        first_step_ = 0;
        const std::string& note = analysis().start_note();
        if (!note.empty()) summary_.notes.push_back("stage " + stages_->name() + ": " + note);
        last_point_ = point_of(analysis().ledger_row());
        if (file_) file_->begin_stage(place_of_stage());
        return true;
    }

    StagePlace place_of_stage() const {
        const std::string kind = kind_of(stages_->settings());
        return {
            stages_->index(), stages_->name().empty() ? kind : stages_->name(), kind, stages_->axis_start()};
    }

    [[noreturn]] void explain_no_step(const std::filesystem::path& path, double time) const {
        const double end = end_of(stages_->settings());
        if (is_path(stages_->settings()))
            throw FileError(
                path,
                fmt::format("cannot be resumed: its arc length is {:.10g} already, after the end", time));
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

    void resume() {
        const RestartRecord record = request_.resumed->place().record;
        recorded_time_ = record.axis_start + record.steps.time;
        const std::filesystem::path path = request_.resumed->path();
        bool has_step = false;
        try {
            has_step = analysis().resume(record);
        } catch (const std::invalid_argument& error) {
            throw FileError(path, std::string("cannot be resumed: ") + error.what());
        }
        if (!has_step) explain_no_step(path, record.steps.time);
        first_step_ = analysis().steps().steps_done();
        rows_ = static_cast<std::int64_t>(request_.resumed->place().steps);
        summary_.totals = record.totals;
        last_point_ = point_of(analysis().ledger_row());
        has_started_ = true;
        last_framed_ = record.is_framed;
        accepted_totals_ = record.totals;
        file_ = std::make_unique<ResultsFile>(
            request_.deck, request_.model, request_.output, std::move(*request_.resumed));
        if (!request_.stages.empty()) file_->begin_stage(place_of_stage());
        request_.report_resumption(record);
    }

    bool start() {
        if (request_.resumed) return true;
        const EquilibriumReport report = analysis().start();
        if (!report.converged()) {
            fail(analysis().explain(report));
            return false;
        }
        const bool is_named = !request_.deck.stages.empty() || is_path(request_.analysis);
        if (file_ && is_named) file_->begin_stage(place_of_stage());
        record();
        has_started_ = true;
        return true;
    }

    // False if it failed; of a branch, the cause says why it cannot be followed further.
    bool step(std::string& cause) {
        const bool can_be_last = file_ && is_path(stages_->settings()) && !stages_->has_critical_points();
        const std::optional<RestartRecord> before =
            can_be_last ? std::optional(restart_record()) : std::nullopt;
        const EquilibriumReport report = analysis().advance();
        const SolverRow& row = analysis().solver_row();
        summary_.totals.rejected_steps += row.rejected_steps;
        if (!report.converged()) {
            const Failure failure = analysis().explain(report);
            if (stages_->branch() == 0) {
                fail(failure);
                return false;
            }
            cause = describe_failure(failure);
            return true;
        }
        ++summary_.totals.steps;
        summary_.totals.newton_iterations += row.newton_iterations;
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

    void record() {
        const PhaseTimer timer(output_seconds_);
        last_framed_ = file_ && is_frame_due();
        const Snapshot snapshot = take_snapshot(last_framed_);
        const LedgerRow ledger = analysis().ledger_row();
        watch_energy(ledger);
        if (request_.observe) request_.observe(snapshot, ledger);
        accepted_totals_ = summary_.totals;
        if (file_) file_->record_step(snapshot, ledger, analysis().solver_row());
        if (last_framed_) file_->write_frame(snapshot);
        recorded_time_ = stages_->axis();
        ++rows_;
        if (file_ && file_->is_flush_due()) {
            if (!stages_->has_critical_points()) file_->set_restart(restart_record());
            file_->flush();
        }
    }

    Snapshot take_snapshot(bool with_elements = true) {
        Snapshot snapshot = analysis().snapshot(with_elements);
        snapshot.time = stages_->axis();
        snapshot.stage = static_cast<int>(stages_->moving_index());
        snapshot.load_factor = analysis().state().time;
        snapshot.branch = stages_->branch();
        snapshot.limit_load_factor = limit_load_factor_of(stages_->settings()).value_or(snapshot.load_factor);
        return snapshot;
    }

    // At the accepted time; the one before it is recorded. The end of a stage is shown.
    bool is_frame_due() const {
        if (analysis().finished() && (!stages_->is_last() || is_path(stages_->settings()))) return true;
        const long interval = frame_interval();
        if (interval > 0) return analysis().steps().is_frame_due(interval);
        const double before = recorded_time_ - stages_->axis_start();
        return !has_started_ || is_frame_time(before, analysis().state().time, end_of(stages_->settings()));
    }

    RestartRecord restart_record() const {
        RestartRecord record = analysis().restart_record();
        record.totals = accepted_totals_;
        record.is_framed = last_framed_;
        record.stage = static_cast<std::int64_t>(stages_->moving_index());
        record.axis_start = stages_->axis_start();
        record.stage_ends = stages_->ends();
        return record;
    }

    void watch_energy(const LedgerRow& ledger) {
        const double energy = ledger.kinetic_energy + ledger.strain_energy;
        RunTotals& totals = summary_.totals;
        totals.largest_energy = std::max({totals.largest_energy, energy, std::abs(ledger.external_work)});
        totals.largest_energy_error = std::max(totals.largest_energy_error, std::abs(ledger.energy_error));
        if (is_timed(stages_->settings()) || analysis().frame() != nullptr) return;
        const EnergyPoint point = point_of(ledger);
        if (has_started_) {
            const std::optional<EnergyJump> jump = find_jump(last_point_, point, totals.largest_energy);
            if (jump) add_jump(*jump, totals.jumps);
        }
        last_point_ = point;
    }

    EnergyPoint point_of(const LedgerRow& ledger) const {
        return {stages_->axis(), ledger.strain_energy, ledger.external_work, ledger.work_uncertainty};
    }

    bool interrupted() {
        if (!request_.is_interrupted()) return false;
        summary_.status = RunStatus::interrupted;
        summary_.reason = "interrupted at " + describe_place();
        return true;
    }

    // Where the analysis is, as messages say it.
    std::string describe_place() const {
        if (!is_path(stages_->settings())) return fmt::format("t = {:.10g}", stages_->axis());
        const std::string place = fmt::format("λ = {:.10g}", analysis().state().time);
        return stages_->branch() == 0 ? place : place + " of " + stages_->paths().back().name;
    }

    void fail(const std::string& reason) {
        summary_.status = RunStatus::failed;
        summary_.reason = reason;
    }

    // Of this part of a run that was resumed.
    void sum_up_cuts() {
        const CutTally& tally = analysis().cuts();
        const StepCuts cuts = tally.count(analysis().steps().steps_done() - first_step_);
        if (!are_worth_telling(cuts)) return;
        add_sentence(count_cuts(cuts) + ": " + tally.describe_reasons(request_.model) +
                         advise_on_cuts(stages_->model(), stages_->settings()),
                     summary_.cuts);
    }

    // To those of earlier stages.
    void add_sentence(const std::string& sentence, std::string& text) const {
        if (!text.empty()) text += "; ";
        text += name_stage() + sentence;
    }

    // Equal steps that are so short that the scheme's error is below what Newton's method leaves.
    void compare_errors() {
        const auto* dynamic = std::get_if<DynamicSettings>(&stages_->settings());
        const double error = analysis().largest_error();
        const double tolerance = analysis().newton().tolerance.value_or(usual_newton_tolerance);
        if (dynamic == nullptr || dynamic->adaptive || error <= 0.0 ||
            tolerance <= tolerable_newton_part * error)
            return;
        add_sentence(
            fmt::format(
                "the estimated errors of the steps, at most {:.2g}, are near what newton.tolerance, {:.2g}, "
                "leaves: "
                "shorter steps may gain nothing. newton.tolerance = {:.0e} would do",
                error,
                tolerance,
                newton_part * error),
            summary_.newton_limit);
    }

    void fail(const Failure& failure) {
        fail(describe_failure(failure));
        summary_.reason_nodes = failure.nodes;
    }

    void close() {
        if (summary_.status == RunStatus::running) summary_.status = RunStatus::complete;
        summary_.place = describe_place();
        leave_path();
        summary_.warnings = stages_->list_warnings();
        summary_.warnings.insert(summary_.warnings.end(), shape_warnings_.begin(), shape_warnings_.end());
        summary_.is_unstable = stages_->is_unstable();
        sum_up_cuts();
        compare_errors();
        if (file_) {
            const PhaseTimer timer(output_seconds_);
            write_end();
            file_->close(summary_.status, summary_.reason, summary_.reason_nodes, join_warnings());
        }
        summary_.time = recorded_time_;
        summary_.phases = stages_->seconds();
        summary_.phases.setup = setup_seconds_;
        summary_.phases.output = output_seconds_;
    }

    // Of a run that ended on it.
    void leave_path() {
        if (!is_path(stages_->settings())) return;
        if (stages_->branch() > 0 && (!file_ || file_->is_sound())) show_last();
        stages_->leave_branches();
        if (!file_ || file_->is_sound()) write_paths();
    }

    // For the file, a line each.
    std::string join_warnings() const {
        std::vector<std::string> lines = summary_.warnings;
        for (const std::string& line : {summary_.cuts, summary_.newton_limit}) {
            if (!line.empty()) lines.push_back(line);
        }
        return fmt::format("{}", fmt::join(lines, "\n"));
    }

    void write_end() {
        // If memory ran out, the last step may not have become a row; a resumed run takes it again.
        if (has_started_ && recorded_time_ != stages_->axis()) return;
        if (has_started_ && !stages_->has_critical_points()) file_->set_restart(restart_record());
        // The last frame, where none was due, is no part of what a run resumes from.
        if (!last_framed_) file_->write_frame(take_snapshot());
    }

    const RunRequest& request_;
    RunSummary summary_;
    double setup_seconds_ = 0.0;
    double output_seconds_ = 0.0;
    std::unique_ptr<StageSequence> stages_;
    std::unique_ptr<ResultsFile> file_;
    std::vector<std::string> shape_warnings_;
    std::size_t written_paths_ = 0;  // number of the last stage whose paths were written, from 1
    std::int64_t rows_ = 0;          // of the histories
    long first_step_ = 0;            // steps done when it was resumed
    EnergyPoint last_point_;         // in statics, of the last step
    RunTotals accepted_totals_;      // without what a step that failed has cost
    bool has_started_ = false;       // has recorded an accepted state
    bool last_framed_ = false;
    double recorded_time_ = 0.0;  // of the last step that is a row of the results
};

}  // namespace

RunSummary run_analysis(const RunRequest& request) {
    double seconds = 0.0;
    RunSummary summary;
    {
        const PhaseTimer timer(seconds);
        Run run(request);
        run.run();
        summary = run.summary();
    }
    summary.wall_seconds = seconds;
    return summary;
}

}  // namespace gxrod
