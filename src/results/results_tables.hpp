#pragma once

#include "model/deck_record.hpp"
#include "results/tables/frame_table.hpp"
#include "results/tables/history_table.hpp"
#include "results/tables/restart_table.hpp"
#include "results/tables/step_table.hpp"

namespace gxrod {

// The datasets of a results file while they are open for appending. Throws Hdf5Error and std::system_error.
class ResultsTables {
  public:
    // Appends after so many steps and frames. `model` must outlive the tables.
    ResultsTables(const Hdf5Handle& root,
                  const DeckRecord& deck,
                  const Model& model,
                  const OutputSettings& output,
                  hsize_t steps,
                  hsize_t frames);

    void append_step(const Snapshot& snapshot, const LedgerRow& ledger, const SolverRow& solver);
    void append_frame(const Snapshot& snapshot);
    // A run can be resumed after the steps and frames that were appended so far.
    void set_restart(RestartRecord record);
    // All rows except those that count the others …
    void flush_rows();
    // … the number of frames, when these are on disk …
    void flush_frame_count();
    // … then the times of steps and frames …
    void flush_times();
    // … and last which slot holds the state to resume from.
    void switch_restart();
    // Removes what an earlier run wrote beyond the last row: of the times, or of all tables.
    void trim_times();
    void trim();
    std::size_t buffered_bytes() const;

  private:
    Hdf5Handle histories_group_, ledger_group_, solver_group_;
    AppendDataset<double> times_;  // of the steps; /ledger/time and /solver/time are links to it
    HistoryTable histories_;
    StepTable<LedgerRow> ledger_;
    StepTable<SolverRow> solver_;
    FrameTable frames_;
    RestartTable restart_;
    hsize_t step_count_, frame_count_;
    int step_numbers_;  // of a row of ledger, solver's record and time
};

}  // namespace gxrod
