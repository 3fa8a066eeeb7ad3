#include "study/resumed_run.hpp"

#include <limits>

#include "machine/file_error.hpp"
#include "machine/phase_timer.hpp"
#include "machine/temporary_folder.hpp"
#include "run/run.hpp"

namespace gxrod {

namespace {

RunRequest make_request(const Problem& problem, const TraceRequest& trace) {
    RunRequest request{problem};
    request.threads = trace.threads;
    return request;
}

void take_totals(const RunSummary& summary, ResumedRun& result) {
    result.steps = summary.totals.steps;
    result.rejected_steps = summary.totals.rejected_steps;
    result.newton_iterations = summary.totals.newton_iterations;
}

void go_on(const Problem& problem,
           const std::filesystem::path& file,
           const TraceRequest& trace,
           ResumedRun& result) {
    bool is_ended = false;
    ResumableFile resumed(file);
    SeriesReader reader(problem, trace.series);
    RunRequest second = make_request(problem, trace);
    second.resumed = &resumed;
    second.observe = [&](const Snapshot& snapshot, const LedgerRow&) {
        result.times.push_back(snapshot.load_factor);
        result.rows.push_back(reader.read(snapshot));
    };
    second.is_interrupted = [&] { return is_ended = trace.is_interrupted(); };
    const RunSummary whole = run_analysis(second);
    if (is_ended) throw StudyInterrupted();
    take_totals(whole, result);
    result.failure = whole.status == RunStatus::complete ? "" : whole.reason;
}

}  // namespace

ResumedRun run_with_stop(const Problem& given, double end_time, const TraceRequest& trace) {
    const TemporaryFolder folder("verify");
    const std::filesystem::path file = folder.path() / "stopped.vtkhdf";
    Problem problem = given;
    problem.output.every = std::numeric_limits<int>::max();  // frames are not looked at
    ResumedRun result;
    const PhaseTimer timer(result.seconds);
    bool is_ended = false;
    RunRequest first = make_request(problem, trace);
    first.results = ResultsFileOptions{file};
    const auto studied = static_cast<int>(problem.stages.size()) - 1;
    first.observe = [&](const Snapshot& snapshot, const LedgerRow&) {
        if (snapshot.stage == studied) result.stopped_at = snapshot.load_factor;
    };
    first.is_interrupted = [&] {
        is_ended = trace.is_interrupted();
        return is_ended || result.stopped_at >= 0.5 * end_time;
    };
    const RunSummary stopped = run_analysis(first);
    if (is_ended) throw StudyInterrupted();
    result.failure = stopped.reason;
    take_totals(stopped, result);
    if (stopped.status != RunStatus::interrupted) return result;

    try {
        go_on(problem, file, trace, result);
    } catch (const WriteError&) {
        throw;
    } catch (const FileError& error) {
        // What is examined here is that a file can be resumed.
        result.failure = error.what();
    }
    return result;
}

}  // namespace gxrod
