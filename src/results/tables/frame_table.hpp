#pragma once

#include "model/model.hpp"
#include "model/settings/settings.hpp"
#include "results/file/append_dataset.hpp"
#include "results/tables/frame_mesh.hpp"
#include "state/records/step_record.hpp"
#include "watch/stress_watch.hpp"

namespace gxrod {

// /VTKHDF: frames in the temporal form of VTKHDF 2.0, which ParaView and VTK (from 9.3) read. Fixed topology;
// N points and E cells are appended per frame; their places along the rods are stored once, with /rods.
// Throws Hdf5Error.
class FrameTable {
  public:
    // Appends after the first `frames` frames; flush_count() updates their number once the times on disk are
    // cut. `model` must outlive the table. Throws std::runtime_error if existing frames have another number
    // of points.
    // `stresses`, which must outlive it too, is nullptr where the output has none.
    FrameTable(const Hdf5Handle& root,
               const Model& model,
               const OutputSettings& output,
               hsize_t frames,
               const StressWatch* stresses = nullptr);

    void append(const Snapshot& snapshot);
    // Writes the frames. Then call flush_count(), and when that is on disk flush_times(); only then readers
    // count the frames. The order matters: VTK reads all times into a buffer of the counted length, which
    // more times would overrun.
    void flush_frames();
    void flush_count();
    void flush_times();
    // Cut each dataset after its last frame.
    void trim_times();
    void trim();
    std::size_t buffered_bytes() const;

  private:
    void create_fields(const Hdf5Handle& root);
    void append_points(const Snapshot& snapshot);
    void append_cells(const Snapshot& snapshot);
    void create_stresses(const Hdf5Handle& cell_data, const Hdf5Handle& offsets, hsize_t cell_rows);
    void flush_if_much(std::vector<AppendDataset<double>>& fields) const;
    template <class Action>
    void for_each_of_rows(Action&& action);

    const Model* model_;
    const StressWatch* stresses_;
    std::vector<ShapeShares> shapes_;  // of each cell, with stresses
    FrameMesh mesh_;
    bool is_compressed_;
    std::int64_t frames_;  // appended

    Hdf5Handle group_, steps_;
    AppendDataset<double> times_;
    AppendDataset<std::int64_t> part_offsets_, part_counts_, point_offsets_, cell_offsets_, topology_offsets_;
    std::vector<AppendDataset<double>> points_;  // Points, PointData in the order of point_labels, radius;
                                                 // with contact its force and gap, with ground its force
    std::vector<AppendDataset<double>>
        cells_;  // CellData in the order of cell_labels, radius, with water wall tension, with stresses those
    Hdf5Handle frame_count_;  // Steps@NSteps
};

}  // namespace gxrod
