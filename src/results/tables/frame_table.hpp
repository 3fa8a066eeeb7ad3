#pragma once

#include "model/model.hpp"
#include "model/settings/settings.hpp"
#include "results/file/append_dataset.hpp"
#include "results/tables/frame_mesh.hpp"
#include "state/records/step_record.hpp"

namespace gxrod {

// /VTKHDF: frames in the temporal form of VTKHDF 2.0, which ParaView and VTK (from 9.3) read. Fixed topology;
// N points and E cells are appended per frame; their places along the rods are stored once, with /rods.
// Throws Hdf5Error.
class FrameTable {
  public:
    // Appends after the first `frames` frames; flush_count() updates their number, once the times are
    // shortened on disk. `model` must outlive the table. Throws std::runtime_error if existing frames have
    // another number of points.
    FrameTable(const Hdf5Handle& root, const Model& model, const OutputSettings& output, hsize_t frames);

    void append(const Snapshot& snapshot);
    // Writes the frames; readers do not count them before flush_count() and, when that is on disk,
    // flush_times(). In this order, because VTK reads all times into a buffer for as many as are counted:
    // more would overrun it.
    void flush_frames();
    void flush_count();
    void flush_times();
    // Ends each dataset with its last frame.
    void trim_times();
    void trim();
    std::size_t buffered_bytes() const;

  private:
    void create_fields(const Hdf5Handle& root);
    void append_points(const Snapshot& snapshot);
    void append_cells(const Snapshot& snapshot);
    void flush_if_much(std::vector<AppendDataset<double>>& fields) const;
    template <class Action>
    void for_each_of_rows(Action&& action);

    const Model* model_;
    FrameMesh mesh_;
    bool is_compressed_;
    std::int64_t frames_;  // appended

    Hdf5Handle group_, steps_;
    AppendDataset<double> times_;
    AppendDataset<std::int64_t> part_offsets_, part_counts_, point_offsets_, cell_offsets_, topology_offsets_;
    std::vector<AppendDataset<double>> points_;  // Points, PointData in the order of point_labels, radius;
                                                 // with contact its force, the last
    std::vector<AppendDataset<double>> cells_;   // CellData in the order of cell_labels, radius
    Hdf5Handle frame_count_;                     // Steps@NSteps
};

}  // namespace gxrod
