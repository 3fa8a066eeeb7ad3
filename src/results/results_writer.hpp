#pragma once

#include <chrono>
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
               std::span<const std::int64_t> reason_nodes);

  private:
    using Clock = std::chrono::steady_clock;

    void commit(OrderedFile::Order order = OrderedFile::Order::growing);
    void close_hdf5();

    OrderedFile file_;
    Hdf5Handle hdf5_;
    Hdf5Handle root_;
    std::optional<ResultsTables> tables_;  // empty once closed
    Clock::time_point next_flush_;
};

}  // namespace gxrod
