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
struct BodyOutline;
class ResultsTables;
class StressTable;

enum class RunStatus { running, complete, failed, interrupted };
// Returns the word for files and summaries, for example "running".
const char* name_of(RunStatus status);

struct ResultsFileOptions {
    std::filesystem::path path;
    Existing existing = Existing::refuse;
};

// The HDF5 file of a run: histories, ledger and solver record of each step, and frames that ParaView reads.
// docs/guide/results.md has its layout.
//
// Steps and frames are gathered in memory; the caller writes them with flush() when it is due. Whenever the
// writer is killed, the file holds every step and frame of the last flush: /VTKHDF/Steps@NSteps is raised
// after everything else is on disk, then /histories/time and /VTKHDF/Steps/Values.
//
// Every member except the destructor throws WriteError if the file cannot be written, and std::bad_alloc if
// there is too little memory for that. The file then still holds all that was written before.
class ResultsFile {
  public:
    // Creates the file. Throws FileError, too, if it cannot be created. `model` must outlive the file. Names
    // of histories must be unique, differ from names of other datasets and have no '/' (asserted).
    ResultsFile(const ResultsFileOptions& options,
                const DeckRecord& deck,
                const Model& model,
                const OutputSettings& output);
    // Resumes a results file at the step that its restart record holds. Later rows are replaced; histories
    // can be added or dropped, the rest of the model must be the same.
    ResultsFile(const DeckRecord& deck, const Model& model, const OutputSettings& output, ResumableFile file);
    // Leaves the status "running" if close() was not called. Never throws.
    ~ResultsFile();
    ResultsFile(const ResultsFile&) = delete;
    ResultsFile& operator=(const ResultsFile&) = delete;

    // Writes what the bodies of the model look like, once for all frames, unless the file has it already.
    void write_outlines(const Model& model, std::span<const BodyOutline> outlines);
    // Assigns the rows that follow to this stage, if the deck has stages.
    void begin_stage(const StagePlace& stage);
    // Writes the results of a stage without steps, and a separate file of its shapes next to this one.
    void write_shapes(const StagePlace& stage,
                      const DeckRecord& deck,
                      const Model& model,
                      std::span<const NodeMotion> equilibrium,
                      const ShapesRecord& record);
    // Writes the results of a stage that follows a path: tables, and a file of the shapes of critical points.
    void write_paths(const StagePlace& stage,
                     const DeckRecord& deck,
                     const Model& model,
                     const PathRecord& paths);
    // Adds a row to the histories, the ledger and the solver record, for each accepted state, t = 0 included.
    void record_step(const Snapshot& snapshot, const LedgerRow& ledger, const SolverRow& solver);
    // Adds a row to the sampled histories at the snapshot's time.
    void record_sample(const Snapshot& snapshot);
    // Records in words the polynomials by which frames and samples within steps are interpolated.
    void note_interpolant(const std::string& words);
    // Adds a frame to /VTKHDF.
    void write_frame(const Snapshot& snapshot);
    // Returns the table of the largest stresses so far; nullptr unless the output has them.
    const StressTable* stresses() const;
    // Returns whether no call has failed so far. After a failure, only the destructor may be called.
    bool is_sound() const { return is_sound_; }
    // Returns whether a flush is due: five times a second, or when much is buffered.
    bool is_flush_due() const;
    // Sets the state, after the steps and frames added so far, from which a run can resume once it is
    // written.
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
    std::unique_ptr<ResultsTables> tables_;  // null once closed
    Clock::time_point next_flush_;
    std::size_t frame_bytes_ = 0;
    bool is_sound_ = true;
    // The last member, so that it is destroyed first: HDF5 can be closed after it, whatever ended the writer.
    std::shared_ptr<void> abandonment_;
};

}  // namespace gxrod
