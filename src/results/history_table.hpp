#pragma once

#include <vector>

#include "results/append_dataset.hpp"
#include "results/history_point.hpp"

namespace gxrod {

// /histories/<name>/<quantity>, one row a step. Throws Hdf5Error.
class HistoryTable {
  public:
    // `model` must outlive the table.
    HistoryTable(const Hdf5Handle& histories,
                 const Model& model,
                 const std::vector<HistoryRequest>& requests);

    void append(const Snapshot& snapshot);
    void flush();
    std::size_t buffered_bytes() const;

  private:
    struct Column {
        Quantity quantity;
        int width;
        AppendDataset<double> values;
    };
    struct History {
        HistoryPoint point;
        std::vector<Column> columns;
    };

    std::vector<History> histories_;
};

}  // namespace gxrod
