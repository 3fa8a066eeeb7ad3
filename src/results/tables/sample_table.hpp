#pragma once

#include "results/histories/history_table.hpp"

namespace gxrod {

inline constexpr const char* samples_group_name = "sampled";

// /sampled: time, and histories at the times of the deck's samples, /sampled/<name>/<quantity>. Throws
// Hdf5Error.
class SampleTable {
  public:
    // Appends after the first `rows` rows. `model` must outlive the table.
    SampleTable(const Hdf5Handle& root,
                const Model& model,
                const std::vector<HistoryRequest>& requests,
                hsize_t rows);

    void append(const Snapshot& snapshot);
    // Writes all rows. The times, which are written last, count the complete rows.
    void flush() { histories_.flush(); }
    void flush_times() { times_.flush(); }
    void trim_times() { times_.trim(); }
    void trim();
    std::size_t buffered_bytes() const { return times_.buffered_bytes() + histories_.buffered_bytes(); }

  private:
    Hdf5Handle group_;
    AppendDataset<double> times_;
    HistoryTable histories_;
};

}  // namespace gxrod
