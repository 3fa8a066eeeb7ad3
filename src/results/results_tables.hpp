#pragma once

#include "model/deck_record.hpp"
#include "results/histories/history_table.hpp"
#include "results/restart/restart_table.hpp"
#include "results/stresses/stress_table.hpp"
#include "results/tables/contact_table.hpp"
#include "results/tables/frame_table.hpp"
#include "results/tables/input_table.hpp"
#include "results/tables/sample_table.hpp"
#include "results/tables/stage_table.hpp"
#include "results/tables/step_table.hpp"

namespace gxrod {

// The datasets of a results file while they are open for appending. Throws Hdf5Error and std::system_error.
class ResultsTables {
  public:
    struct Rows {
        hsize_t steps, frames, samples;
    };

    // Appends after so many rows. `model` must outlive the tables.
    ResultsTables(const Hdf5Handle& root,
                  const DeckRecord& deck,
                  const Model& model,
                  const OutputSettings& output,
                  const Rows& rows);

    void begin_stage(const StagePlace& stage) { stages_.begin_stage(stage, rows_.steps); }
    void write_shapes(const StagePlace& stage,
                      const Model& model,
                      const ShapesRecord& record,
                      std::span<const double> scales) {
        stages_.write_shapes(stage, model, record, scales, rows_.steps);
    }
    void write_paths(const StagePlace& stage, const PathRecord& paths) {
        stages_.write_paths(stage, paths, rows_.steps);
    }
    // Returns the largest stresses of all steps so far; nullptr unless the output has them.
    const StressTable* stresses() const { return stresses_ ? &*stresses_ : nullptr; }

    void append_step(const Snapshot& snapshot, const LedgerRow& ledger, const SolverRow& solver);
    void append_sample(const Snapshot& snapshot);
    void append_frame(const Snapshot& snapshot);
    // Sets the state from which a run can resume, after the steps and frames that were appended so far.
    void set_restart(RestartRecord record);
    // Call these four in this order. The first writes all rows except the counts and times …
    void flush_rows();
    // … the second the number of frames, when these are on disk …
    void flush_frame_count();
    // … the third the times of steps and frames …
    void flush_times();
    // … and the last names the slot with the state from which to resume.
    void switch_restart();
    // Remove rows that an earlier run wrote beyond the last row, from the times or from all tables.
    void trim_times();
    void trim();
    // Removes stages after this one.
    void remove_stages_after(std::int64_t stage) { stages_.remove_after(stage); }
    std::size_t buffered_bytes() const;

  private:
    Hdf5Handle histories_group_, ledger_group_, solver_group_;
    AppendDataset<double> times_;  // times of the steps; /ledger/time and /solver/time are links to it
    StageTable stages_;
    HistoryTable histories_;
    StepTable<LedgerRow> ledger_;
    StepTable<SolverRow> solver_;
    InputTable inputs_;
    std::optional<StressTable> stresses_;  // if the output has stresses
    FrameTable frames_;
    std::optional<ContactTable> contacts_;  // if the model has contact
    std::optional<SampleTable> samples_;    // if the deck asks for samples, or the file has some
    RestartTable restart_;
    Rows rows_;
    int step_numbers_;  // numbers in a row of ledger, solver record and time
};

}  // namespace gxrod
