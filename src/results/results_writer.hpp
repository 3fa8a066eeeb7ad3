#pragma once

#include <chrono>
#include <filesystem>
#include <memory>
#include <optional>
#include <span>
#include <string>

#include "model/deck_record.hpp"
#include "model/model.hpp"
#include "model/settings.hpp"
#include "results/ordered_file.hpp"
#include "results/results_tables.hpp"
#include "results/resumable_file.hpp"

namespace gxrod {

// Writes a results file: what ResultsFile does, with errors as they come.
class ResultsWriter {
  public:
    // Takes over the descriptor of an empty file. `model` must outlive the writer.
    ResultsWriter(int descriptor, const DeckRecord& deck, const Model& model, const OutputSettings& output);
    // Goes on with a file.
    ResultsWriter(ResumableFile file,
                  const DeckRecord& deck,
                  const Model& model,
                  const OutputSettings& output);
    // Writes what is gathered, unless writing has failed before.
    ~ResultsWriter();
    ResultsWriter(const ResultsWriter&) = delete;
    ResultsWriter& operator=(const ResultsWriter&) = delete;

    void record_step(const Snapshot& snapshot, const LedgerRow& ledger, const SolverRow& solver);
    void write_frame(const Snapshot& snapshot);
    bool is_flush_due() const;
    void set_restart(RestartRecord record);
    void flush();
    void close(const std::string& status,
               const std::string& reason,
               std::span<const std::int64_t> reason_nodes,
               const std::string& warnings);

    // Whether nothing has failed so far. If something has, the file stays as it was last written.
    bool is_sound() const { return is_sound_; }
    // Whether the file is that of this name.
    bool is_at(const std::filesystem::path& path) const { return file_->is_at(path); }

  private:
    // Whatever ends the writer, HDF5 can be closed after it.
    struct Abandonment {
        OrderedFile& file;
        ~Abandonment() { file.abandon(); }
    };
    using Clock = std::chrono::steady_clock;

    void commit(OrderedFile::Order order = OrderedFile::Order::growing);
    void close_hdf5();
    template <class Action>
    void attempt(std::size_t bytes, Action&& action);

    std::shared_ptr<OrderedFile> file_;
    Hdf5Handle hdf5_;
    Hdf5Handle root_;
    std::optional<ResultsTables> tables_;  // empty once closed
    Clock::time_point next_flush_;
    std::size_t frame_bytes_ = 0;
    bool is_sound_ = true;
    Abandonment abandonment_{*file_};  // last, so that it goes first
};

}  // namespace gxrod
