#include "run/run.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <new>

#include "machine/file_error.hpp"
#include "model/evaluation_error.hpp"
#include "model/frame_interval.hpp"
#include "model/newton_choice.hpp"
#include "results/tables/history_point.hpp"

namespace gxrod {

namespace {

class Run {
  public:
    explicit Run(const RunRequest& request) : request_(request), analysis_(build(request, setup_seconds_)) {
        summary_.is_static = std::holds_alternative<StaticSettings>(request.analysis);
        analysis_->watch(list_rod_places(request.output.histories));
        if (request.resumed) {
            resume();
        } else if (request.results) {
            file_ =
                std::make_unique<ResultsFile>(*request.results, request.deck, request.model, request.output);
        }
        summary_.nodes = static_cast<long>(request.model.nodes.size());
        summary_.elements = static_cast<long>(analysis_->system().element_count());
        summary_.unknowns = analysis_->system().equations().count();
        summary_.threads = analysis_->system().team().size();
    }

    void run() {
        try {
            if (start()) {
                while (!analysis_->finished() && !interrupted() && step()) {
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
    static std::unique_ptr<SteppedAnalysis> build(const RunRequest& request, double& seconds) {
        const PhaseTimer timer(seconds);
        return make_analysis(request.model, request.analysis, request.threads);
    }

    [[noreturn]] void explain_no_step(const std::filesystem::path& path, double time) const {
        const auto* dynamic = std::get_if<DynamicSettings>(&request_.analysis);
        const double end = dynamic ? dynamic->end_time : 1.0;
        if (time > end) {
            throw FileError(
                path,
                fmt::format(
                    "cannot be resumed: it is at t = {:.10g} already, after the end, {:.10g}", time, end));
        }
        throw FileError(
            path,
            fmt::format("cannot be resumed: steps of {:.10g} do not meet t = {:.10g}, where it stopped",
                        analysis_->steps().time_step(),
                        time),
            "take a step that goes into this time and into end_time, as that of the run does");
    }

    void resume() {
        const RestartRecord& record = request_.resumed->place().record;
        recorded_time_ = record.steps.time;
        const std::filesystem::path path = request_.resumed->path();
        bool has_step = false;
        try {
            has_step = analysis_->resume(record);
        } catch (const std::invalid_argument& error) {
            throw FileError(path, std::string("cannot be resumed: ") + error.what());
        }
        if (!has_step) explain_no_step(path, record.steps.time);
        first_step_ = analysis_->steps().steps_done();
        summary_.totals = record.totals;
        last_point_ = point_of(analysis_->ledger_row());
        has_started_ = true;
        last_framed_ = record.is_framed;
        accepted_totals_ = record.totals;
        file_ = std::make_unique<ResultsFile>(
            request_.deck, request_.model, request_.output, std::move(*request_.resumed));
        request_.report_resumption(recorded_time_);
    }

    bool start() {
        if (request_.resumed) return true;
        const EquilibriumReport report = analysis_->start();
        if (!report.converged()) {
            fail(analysis_->explain(report));
            return false;
        }
        record();
        has_started_ = true;
        return true;
    }

    bool step() {
        const EquilibriumReport report = analysis_->advance();
        const SolverRow& row = analysis_->solver_row();
        summary_.totals.rejected_steps += row.rejected_steps;
        if (!report.converged()) {
            fail(analysis_->explain(report));
            return false;
        }
        ++summary_.totals.steps;
        summary_.totals.newton_iterations += row.newton_iterations;
        record();
        const StepSequence& steps = analysis_->steps();
        request_.report_progress({steps.steps_done(),
                                  steps.steps_in_all(),
                                  steps.part_done(),
                                  analysis_->state().time,
                                  row.time_step,
                                  row.newton_iterations});
        return true;
    }

    void record() {
        const PhaseTimer timer(output_seconds_);
        last_framed_ = file_ && is_frame_due();
        const Snapshot snapshot = analysis_->snapshot(last_framed_);
        const LedgerRow ledger = analysis_->ledger_row();
        watch_energy(ledger);
        if (request_.observe) request_.observe(snapshot, ledger);
        accepted_totals_ = summary_.totals;
        if (file_) file_->record_step(snapshot, ledger, analysis_->solver_row());
        if (last_framed_) file_->write_frame(snapshot);
        recorded_time_ = analysis_->state().time;
        if (file_ && file_->is_flush_due()) {
            file_->set_restart(restart_record());
            file_->flush();
        }
    }

    // At the accepted time; the one before it is recorded.
    bool is_frame_due() const {
        if (request_.output.every > 0) return analysis_->steps().is_frame_due(request_.output.every);
        const double time = analysis_->state().time;
        return !has_started_ ||
               is_frame_time(recorded_time_, time, std::get<DynamicSettings>(request_.analysis).end_time);
    }

    RestartRecord restart_record() const {
        RestartRecord record = analysis_->restart_record();
        record.totals = accepted_totals_;
        record.is_framed = last_framed_;
        return record;
    }

    void watch_energy(const LedgerRow& ledger) {
        const double energy = ledger.kinetic_energy + ledger.strain_energy;
        RunTotals& totals = summary_.totals;
        totals.largest_energy = std::max({totals.largest_energy, energy, std::abs(ledger.external_work)});
        totals.largest_energy_error = std::max(totals.largest_energy_error, std::abs(ledger.energy_error));
        if (!summary_.is_static) return;
        const EnergyPoint point = point_of(ledger);
        if (has_started_) {
            const std::optional<EnergyJump> jump = find_jump(last_point_, point, totals.largest_energy);
            if (jump) add_jump(*jump, totals.jumps);
        }
        last_point_ = point;
    }

    EnergyPoint point_of(const LedgerRow& ledger) const {
        return {analysis_->state().time, ledger.strain_energy, ledger.external_work, ledger.work_uncertainty};
    }

    bool interrupted() {
        if (!request_.is_interrupted()) return false;
        summary_.status = RunStatus::interrupted;
        summary_.reason = fmt::format("interrupted at t = {:.10g}", analysis_->state().time);
        return true;
    }

    void fail(const std::string& reason) {
        summary_.status = RunStatus::failed;
        summary_.reason = reason;
    }

    // Of this part of a run that was resumed.
    void sum_up_cuts() {
        const CutTally& tally = analysis_->cuts();
        const StepCuts cuts = tally.count(analysis_->steps().steps_done() - first_step_);
        if (!are_worth_telling(cuts)) return;
        summary_.cuts = count_cuts(cuts) + ": " + tally.describe_reasons(request_.model) +
                        advise_on_cuts(request_.model, request_.analysis);
    }

    // Equal steps that are so short that the scheme's error is below what Newton's method leaves.
    void compare_errors() {
        const auto* dynamic = std::get_if<DynamicSettings>(&request_.analysis);
        const double error = analysis_->largest_error();
        const double tolerance = analysis_->newton().tolerance.value_or(usual_newton_tolerance);
        if (dynamic == nullptr || dynamic->adaptive || error <= 0.0 ||
            tolerance <= tolerable_newton_part * error)
            return;
        summary_.newton_limit = fmt::format(
            "the estimated errors of the steps, at most {:.2g}, are near what newton.tolerance, {:.2g}, "
            "leaves: "
            "shorter steps may gain nothing. newton.tolerance = {:.0e} would do",
            error,
            tolerance,
            newton_part * error);
    }

    void fail(const Failure& failure) {
        fail(describe_failure(failure));
        summary_.reason_nodes = failure.nodes;
    }

    void close() {
        if (summary_.status == RunStatus::running) summary_.status = RunStatus::complete;
        summary_.warnings = analysis_->list_warnings();
        summary_.is_unstable = analysis_->is_unstable();
        sum_up_cuts();
        compare_errors();
        if (file_) {
            const PhaseTimer timer(output_seconds_);
            write_end();
            file_->close(summary_.status, summary_.reason, summary_.reason_nodes, join_warnings());
        }
        summary_.time = recorded_time_;
        summary_.phases = analysis_->seconds();
        summary_.phases.setup = setup_seconds_;
        summary_.phases.output = output_seconds_;
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
        if (has_started_ && recorded_time_ != analysis_->state().time) return;
        if (has_started_) file_->set_restart(restart_record());
        // The last frame, where none was due, is no part of what a run resumes from.
        if (!last_framed_) file_->write_frame(analysis_->snapshot());
    }

    const RunRequest& request_;
    RunSummary summary_;
    double setup_seconds_ = 0.0;
    double output_seconds_ = 0.0;
    std::unique_ptr<SteppedAnalysis> analysis_;
    std::unique_ptr<ResultsFile> file_;
    long first_step_ = 0;        // steps done when it was resumed
    EnergyPoint last_point_;     // in statics, of the last step
    RunTotals accepted_totals_;  // without what a step that failed has cost
    bool has_started_ = false;   // has recorded an accepted state
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
