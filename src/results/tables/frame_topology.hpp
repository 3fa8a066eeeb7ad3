#pragma once

#include "results/file/hdf5_objects.hpp"
#include "results/tables/frame_mesh.hpp"

namespace gxrod {

// Writes the data in /VTKHDF that all frames of a file share: version, type and cells. Throws Hdf5Error.
void write_frame_topology(const Hdf5Handle& vtkhdf, const FrameMesh& mesh, std::size_t points);

}  // namespace gxrod
