#include "results/tables/sample_table.hpp"

namespace gxrod {

SampleTable::SampleTable(const Hdf5Handle& root,
                         const Model& model,
                         const std::vector<HistoryRequest>& requests,
                         hsize_t rows)
    : group_(require_group(root, samples_group_name)),
      times_(group_, {"time", "time of each sample", "none", "time"}, scalar_row, rows),
      histories_(group_, model, requests, rows) {}

void SampleTable::append(const Snapshot& snapshot) {
    times_.append(snapshot.time);
    histories_.append(snapshot);
}

void SampleTable::trim() {
    times_.trim();
    histories_.trim();
}

}  // namespace gxrod
