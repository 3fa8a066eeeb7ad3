#pragma once

#include <chrono>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <memory>
#include <span>
#include <string>

#include "model/deck_record.hpp"
#include "model/model.hpp"
#include "model/settings/settings.hpp"
#include "results/file/output_file.hpp"
#include "results/resumable_file.hpp"
#include "results/stage_place.hpp"
#include "state/records/path_record.hpp"
#include "state/records/restart_record.hpp"
#include "state/records/shapes_record.hpp"
#include "state/records/step_record.hpp"

namespace gxrod {

class OrderedFile;
class ResultsTables;

enum class RunStatus { running, complete, failed, interrupted };
// As written in files and summaries: "running" …
const char* name_of(RunStatus status);

struct ResultsFileOptions {
    std::filesystem::path path;
    Existing existing = Existing::refuse;
};

// The HDF5 file of a run: histories, ledger and solver record of each step, and frames that ParaView reads.
// docs/guide/results.md has its layout.
//
// Steps and frames are gathered in memory; the caller writes them with flush() when that is due. Whenever the
// writer is killed, the file holds every step and frame of the last flush: /VTKHDF/Steps@NSteps is raised
// after everything else is on disk, then /histories/time and /VTKHDF/Steps/Values.
//
// Every member but the destructor throws WriteError if the file cannot be written, std::bad_alloc if there is
// too little memory for that. After that the file still holds what was written before.
class ResultsFile {
  public:
    // Throws FileError, too, if the file cannot be created. `model` must outlive the file. Names of histories
    // are unique, not those of other datasets, and without '/' (asserted).
    ResultsFile(const ResultsFileOptions& options,
                const DeckRecord& deck,
                const Model& model,
                const OutputSettings& output);
    // Resumes a results file at the step that its restart record holds. Later rows are replaced; histories
    // can be added or dropped, the rest of the model must be the same.
    ResultsFile(const DeckRecord& deck, const Model& model, const OutputSettings& output, ResumableFile file);
    // Without close() the status stays "running". Never throws.
    ~ResultsFile();
    ResultsFile(const ResultsFile&) = delete;
    ResultsFile& operator=(const ResultsFile&) = delete;

    // The rows that follow belong to this stage, if the deck has stages.
    void begin_stage(const StagePlace& stage);
    // What a stage has found that takes no steps; with a file of its shapes beside this one.
    void write_shapes(const StagePlace& stage,
                      const DeckRecord& deck,
                      const Model& model,
                      std::span<const NodeMotion> equilibrium,
                      const ShapesRecord& record);
    // What a stage that goes along a path has found: tables, and a file of the shapes of critical points.
    void write_paths(const StagePlace& stage,
                     const DeckRecord& deck,
                     const Model& model,
                     const PathRecord& paths);
    // Adds a row to the histories, the ledger and the solver record: each accepted step, t = 0 included.
    void record_step(const Snapshot& snapshot, const LedgerRow& ledger, const SolverRow& solver);
    // Adds a row to the sampled histories, at a time of its own.
    void record_sample(const Snapshot& snapshot);
    // Notes which polynomials frames and samples within steps are of.
    void note_interpolant(const std::string& words);
    // Adds a frame to /VTKHDF.
    void write_frame(const Snapshot& snapshot);
    // Whether no call has failed so far. After a failure, only the destructor may be called.
    bool is_sound() const { return is_sound_; }
    // Whether it is time to flush: five times a second, or when much is buffered.
    bool is_flush_due() const;
    // The state that a resumed run starts from, once it is written: after the steps and frames added so far.
    void set_restart(RestartRecord record);
    void flush();
    // Flushes, then writes the status, its reason, the nodes that the reason names and the lines of
    // `warnings`. Nothing may be added afterwards. Throws FileError, too, if the file has been renamed.
    void close(RunStatus status,
               const std::string& reason,
               std::span<const std::int64_t> reason_nodes = {},
               const std::string& warnings = "");

  private:
    using Clock = std::chrono::steady_clock;
    struct Hdf5File;
    struct RowCounts {
        std::uint64_t steps = 0;
        std::uint64_t frames = 0;
        std::uint64_t samples = 0;
    };

    void take_over(int descriptor);
    void open_tables(const DeckRecord& deck,
                     const Model& model,
                     const OutputSettings& output,
                     const RowCounts& after);
    void resume(const DeckRecord& deck,
                const Model& model,
                const OutputSettings& output,
                ResumableFile& file);
    void close_hdf5();
    template <class Action>
    void attempt(std::size_t bytes, Action&& action);

    std::filesystem::path path_;
    std::shared_ptr<OrderedFile> file_;
    std::unique_ptr<Hdf5File> hdf5_;
    std::unique_ptr<ResultsTables> tables_;  // none once closed
    Clock::time_point next_flush_;
    std::size_t frame_bytes_ = 0;
    bool is_sound_ = true;
    // Last, so that it is destroyed first: HDF5 can be closed after it, whatever ended the writer.
    std::shared_ptr<void> abandonment_;
};

}  // namespace gxrod
