#pragma once

#include <optional>
#include <string>
#include <vector>

#include "results/file/append_dataset.hpp"
#include "watch/history_watch.hpp"

namespace gxrod {

// /histories/<name>/<quantity>, one row a step. Throws Hdf5Error.
class HistoryTable {
  public:
    // Appends after the first `rows` rows. New quantities have NaN in these rows; quantities no longer
    // requested have NaN from there on. `model` must outlive the table.
    HistoryTable(const Hdf5Handle& histories,
                 const Model& model,
                 const std::vector<HistoryRequest>& requests,
                 hsize_t rows);

    void append(const Snapshot& snapshot);
    void flush();
    void trim();
    std::size_t buffered_bytes() const;

  private:
    struct Column {
        const Quantity& quantity;
        AppendDataset<double> values;
    };
    // A dataset that is no longer requested.
    struct Ended {
        int width;
        AppendDataset<double> values;
    };
    struct History {
        HistoryWatch watch;
        std::vector<Column> columns;
    };

    void add_history(const Hdf5Handle& group,
                     const Model& model,
                     const HistoryWatch& watch,
                     const HistoryRequest& request,
                     hsize_t rows);
    void add_ended(const Hdf5Handle& group, const std::vector<std::string>& recorded, hsize_t rows);
    template <class Action>
    void for_each_dataset(Action&& action);

    std::vector<History> histories_;
    std::vector<Ended> ended_;
};

}  // namespace gxrod
