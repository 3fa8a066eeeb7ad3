#pragma once

#include "model/model.hpp"
#include "results/file/hdf5_objects.hpp"

namespace gxrod {

// The groups of frames to which what stays the same in all of them is added.
struct PlaceGroups {
    const Hdf5Handle& root;
    const Hdf5Handle& point_data;
    const Hdf5Handle& point_data_offsets;
    const Hdf5Handle& cell_data;
    const Hdf5Handle& cell_data_offsets;
    hid_t no_offsets;  // a dataset of a 0 for each frame
};

// Writes, once for all frames, where points and cells lie along the rods, and the table /rods. Nothing if a
// file has them. Throws Hdf5Error.
void write_rod_places(const PlaceGroups& groups, const Model& model);

}  // namespace gxrod
