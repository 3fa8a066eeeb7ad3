#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "analyses/static.hpp"
#include "check/failure_advice.hpp"
#include "check/findings/finding.hpp"
#include "model/deck_record.hpp"
#include "model/settings/settings.hpp"
#include "model/settings/stage.hpp"
#include "results/energy_warning.hpp"
#include "results/results_file.hpp"
#include "run/stage_sequence.hpp"

// A whole run: from a model to a results file.
namespace gxrod {

struct Progress {
    std::string stage;  // its name; "" of a run of one
    long step;          // steps done
    long steps;         // of the whole run; 0 if not known beforehand
    double part;        // of the run done, 0 … 1
    double time;
    double time_step;  // of the last step
    int newton_iterations;
};

struct RunRequest {
    const Model& model;
    const AnalysisSettings& analysis;
    const OutputSettings& output;
    const DeckRecord& deck;
    std::optional<ResultsFileOptions> results;  // nowhere, if neither this nor `resumed` is given
    ResumableFile* resumed = nullptr;           // taken over, to resume it instead of writing a new file
    std::function<void(const Progress&)> report_progress = [](const Progress&) {};
    // From where it resumes.
    std::function<void(const RestartRecord&)> report_resumption = [](const RestartRecord&) {};
    std::function<bool()> is_interrupted = [] { return false; };  // asked after each step
    int threads = 1;                                              // their number changes no result
    // Each accepted step, t = 0 included; without frames' values of elements.
    std::function<void(const Snapshot&, const LedgerRow&)> observe = {};
    // All stages, if there are several; the first one is `analysis` on `model`.
    std::span<const StagePlan> stages = {};
    // What was found of the model beforehand: the warnings among them are the first ones of the run.
    std::vector<Finding> examined = {};
};

struct RunSummary {
    RunStatus status = RunStatus::running;
    std::string reason;                      // of a failure
    std::vector<std::int64_t> reason_nodes;  // that it names
    std::optional<Failure> failure;          // of a step
    std::string cuts;                        // if steps were cut more than a few times: how often and why
    std::string newton_limit;                // that Newton's tolerance bounds the accuracy, or ""
    bool deck_fault = false;                 // whether the deck is to blame: a load without a finite value
    bool out_of_memory = false;
    std::vector<std::string> notes;   // what a user may want to know of how stages begin, a sentence each
    std::vector<FoundShapes> shapes;  // in the order of the stages
    std::vector<PathRecord> paths;    // of stages that go along one, in their order
    // Critical points of paths, and what statics relaxed to, a sentence each.
    std::vector<std::string> findings;
    // All that is to be known before the results are trusted, a sentence each: of the model, of equilibria,
    // shapes and paths, `cuts`, `newton_limit` and what energies say.
    std::vector<std::string> warnings;
    bool is_unstable = false;  // whether equilibria were accepted that no structure would stay at
    long nodes = 0;
    long elements = 0;
    long unknowns = 0;
    bool is_static = false;
    std::string integrators;  // as DeckRecord's
    RunTotals totals;         // since t = 0, also of a resumed run
    double time = 0.0;        // reached
    std::string place;        // the same for messages: "t = 1", "λ = 2 of path.1+"
    int threads = 1;
    double wall_seconds = 0.0;
    PhaseSeconds phases;

    EnergySurvey energy() const {
        return {is_static, totals.largest_energy, totals.largest_energy_error, totals.jumps};
    }
};

// Runs and leaves a closed results file, whatever happens. Not converging, running out of memory, or a load
// that is NaN, is a failed summary. Throws FileError if the file cannot be created, or cannot be
// resumed with this analysis; WriteError if it cannot be written, and std::bad_alloc if there is too little
// memory for that: what was written stays.
RunSummary run_analysis(const RunRequest& request);

}  // namespace gxrod
