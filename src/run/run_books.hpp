#pragma once

#include <optional>
#include <string>
#include <vector>

#include "model/model.hpp"
#include "results/energy_warning.hpp"
#include "run/run.hpp"
#include "run/stage_sequence.hpp"

namespace gxrod {

// Keeps the summary of a run while it proceeds.
class RunBooks {
  public:
    // Takes the findings of the checks of the model.
    RunBooks(const Model& model, const std::vector<Finding>& examined);

    RunSummary& summary() { return summary_; }
    const RunSummary& summary() const { return summary_; }

    // Marks the run as complete unless it has ended otherwise.
    void complete();
    // Marks the run as running again, after a return to an earlier state.
    void reopen();
    void fail(const std::string& reason);
    void fail(const Failure& failure, const std::string& prefix = "");
    // Begins a stage after the first, or a resumed run.
    void begin(const StageSequence& stages);
    void begin_branch(const StageSequence& stages);
    // Checks the energies of an accepted state: in statics, work that differs from strain energy counts as a
    // jump.
    void watch_energy(const StageSequence& stages, const LedgerRow& ledger, bool is_first);
    // Sums up the stage whose steps led to the state, once, at its end or the end of the run: whether steps
    // were cut often, or are too short for Newton's tolerance.
    void sum_up_stage(const StageSequence& stages, std::int64_t stage_count);
    void add_paths(const PathRecord& paths);
    void add_warning(std::string warning) { warnings_.push_back(std::move(warning)); }
    // Ends the run and completes the list of warnings.
    void close(const StageSequence& stages, std::int64_t stage_count);
    // Returns the warnings for the file, one per line.
    std::string join_warnings() const;

  private:
    void note_pivots(const StageSequence& stages, const std::string& prefix);
    void sum_up_cuts(const StageSequence& stages, const std::string& prefix);
    void compare_errors(const StageSequence& stages, const std::string& prefix);

    const Model& model_;
    RunSummary summary_;
    std::vector<std::string> examined_;     // warnings of the model
    std::vector<std::string> warnings_;     // warnings on shapes and paths
    long first_step_ = 0;                   // steps done when the stage began or was resumed
    EnergyPoint last_point_;                // last step in statics
    std::optional<std::size_t> summed_up_;  // last stage that was summed up
};

// Returns the words that precede a sentence about the current stage.
std::string name_stage(const StageSequence& stages, std::int64_t stage_count);

}  // namespace gxrod
