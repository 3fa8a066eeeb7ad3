#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "analyses/static.hpp"
#include "check/failure_advice.hpp"
#include "check/findings/finding.hpp"
#include "model/problem.hpp"
#include "results/energy_warning.hpp"
#include "results/results_file.hpp"
#include "run/stage_sequence.hpp"

// A whole run: from a model to a results file.
namespace gxrod {

struct Progress {
    std::string stage;  // its name; "" if the run has only one
    long step;          // steps done
    long steps;         // steps of the whole run; 0 if not known in advance
    double part;        // share of the run that is done, 0 … 1
    double time;
    double time_step;  // length of the last step
    int newton_iterations;
};

struct RunRequest {
    const Problem& problem;
    std::optional<ResultsFileOptions> results = {};  // none is written without it or `resumed`
    ResumableFile* resumed = nullptr;                // a file to resume instead of writing a new one
    std::function<void(const Progress&)> report_progress = [](const Progress&) {};
    // Called with the record from which a run resumes.
    std::function<void(const RestartRecord&)> report_resumption = [](const RestartRecord&) {};
    std::function<bool()> is_interrupted = [] { return false; };  // asked after each step
    std::string until = {};  // the stage after which the run stops, to be resumed; "" if at its end
    int threads = 1;         // their number changes no result
    // Called at each accepted state, t = 0 included, without values of elements for frames.
    std::function<void(const Snapshot&, const LedgerRow&)> observe = {};
    // Called when another stage with steps has started, before its first step.
    std::function<void()> observe_stage = {};
    // Findings of the checks of the model; their warnings are the first ones of the run.
    std::vector<Finding> examined = {};
};

struct RunSummary {
    RunStatus status = RunStatus::running;
    std::string reason;                      // reason of a failure
    bool stopped_as_asked = false;           // interrupted after the stage RunRequest::until
    std::vector<std::int64_t> reason_nodes;  // nodes that it names
    std::optional<Failure> failure;          // failure of a step
    std::string cuts;                        // how often and why steps were cut, if more than a few times
    std::string newton_limit;                // says if Newton's tolerance bounds the accuracy; else ""
    bool deck_fault = false;                 // whether the deck is the cause: a load without a finite value
    bool out_of_memory = false;
    std::vector<std::string> notes;   // remarks on how stages begin, a sentence each
    std::vector<FoundShapes> shapes;  // in the order of the stages
    std::vector<PathRecord> paths;    // paths of stages, in their order
    // Critical points of paths and states to which statics relaxed, a sentence each.
    std::vector<std::string> findings;
    // Warnings to read before the results are trusted, a sentence each: on the model, equilibria, shapes,
    // paths and energies, with `cuts` and `newton_limit`.
    std::vector<std::string> warnings;
    bool is_unstable = false;  // whether unstable equilibria were accepted
    long nodes = 0;
    long elements = 0;
    long unknowns = 0;
    bool is_static = false;
    std::string integrators;  // as in DeckRecord
    RunTotals totals;         // since t = 0, also if the run was resumed
    double time = 0.0;        // reached
    std::string place;        // `time` for messages: "t = 1", "λ = 2 of path.1+"
    int threads = 1;
    double wall_seconds = 0.0;
    PhaseSeconds phases;

    EnergySurvey energy() const {
        return {is_static, totals.largest_energy, totals.largest_energy_error, totals.jumps};
    }
};

// Runs, and closes the results file whatever happens. The summary reports a failure if a step does not
// converge, memory runs out or a load is NaN. Throws FileError if the file cannot be created, or cannot be
// resumed with this analysis; WriteError if it cannot be written, and std::bad_alloc if there is too little
// memory for that: the data written so far stay.
RunSummary run_analysis(const RunRequest& request);

}  // namespace gxrod
