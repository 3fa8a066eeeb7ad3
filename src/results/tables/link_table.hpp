#pragma once

#include "model/model.hpp"
#include "results/file/hdf5_objects.hpp"

namespace gxrod {

// Writes, once for all frames, the tables /joints, /springs and /bushings of a model that has them, unless
// the file has them already: what each joins, and where. Throws Hdf5Error.
void write_link_tables(const Hdf5Handle& root, const Model& model);

}  // namespace gxrod
