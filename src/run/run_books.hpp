#pragma once

#include <optional>
#include <string>
#include <vector>

#include "model/model.hpp"
#include "results/energy_warning.hpp"
#include "run/run.hpp"
#include "run/stage_sequence.hpp"

namespace gxrod {

// What a run sums up about itself: its summary, while it goes on.
class RunBooks {
  public:
    // `examined` is what was found of the model beforehand.
    RunBooks(const Model& model, const std::vector<Finding>& examined);

    RunSummary& summary() { return summary_; }
    const RunSummary& summary() const { return summary_; }

    // Nothing comes any more, though nothing failed. Nothing if that is known.
    void complete();
    // Back at an earlier state: what ended the run is no longer so.
    void reopen();
    void fail(const std::string& reason);
    void fail(const Failure& failure, const std::string& prefix = "");
    // At the start of a stage after the first, or where the run was resumed.
    void begin(const StageSequence& stages);
    void begin_branch(const StageSequence& stages);
    // Of an accepted state; in statics work that parts from the strain energy counts as a jump.
    void watch_energy(const StageSequence& stages, const LedgerRow& ledger, bool is_first);
    // Sums up the stage whose steps led to the state, once, at its end or the end of the run: often cut
    // steps, steps shorter than Newton's method bears.
    void sum_up_stage(const StageSequence& stages, std::int64_t stage_count);
    void add_paths(const PathRecord& paths);
    void add_warning(std::string warning) { warnings_.push_back(std::move(warning)); }
    // The run is over: the list of warnings is complete.
    void close(const StageSequence& stages, std::int64_t stage_count);
    // For the file, a line each.
    std::string join_warnings() const;

  private:
    void note_pivots(const StageSequence& stages, const std::string& prefix);
    void sum_up_cuts(const StageSequence& stages, const std::string& prefix);
    void compare_errors(const StageSequence& stages, const std::string& prefix);

    const Model& model_;
    RunSummary summary_;
    std::vector<std::string> examined_;     // warnings of the model
    std::vector<std::string> warnings_;     // of shapes and paths
    long first_step_ = 0;                   // steps done where the stage was begun or resumed
    EnergyPoint last_point_;                // in statics, of the last step
    std::optional<std::size_t> summed_up_;  // the last stage that was
};

// Before a sentence about the stage at hand.
std::string name_stage(const StageSequence& stages, std::int64_t stage_count);

}  // namespace gxrod
