#pragma once

#include "model/model.hpp"
#include "results/file/hdf5_objects.hpp"

namespace gxrod {

// The groups of frames to which places along the rods are added.
struct PlaceGroups {
    const Hdf5Handle& root;
    const Hdf5Handle& point_data;
    const Hdf5Handle& point_data_offsets;
    const Hdf5Handle& cell_data;
    const Hdf5Handle& cell_data_offsets;
    hid_t no_offsets;  // a dataset with a 0 for each frame
};

// Writes, once for all frames, the places of points and cells along the rods, and the table /rods, unless the
// file has them already. Throws Hdf5Error.
void write_rod_places(const PlaceGroups& groups, const Model& model);

}  // namespace gxrod
