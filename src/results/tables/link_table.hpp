#pragma once

#include "model/model.hpp"
#include "results/file/hdf5_objects.hpp"

namespace gxrod {

// Writes, once for all frames, the tables /joints, /springs and /bushings if the model has them, unless the
// file has them already: the ends of each, and where they are. Throws Hdf5Error.
void write_link_tables(const Hdf5Handle& root, const Model& model);

}  // namespace gxrod
