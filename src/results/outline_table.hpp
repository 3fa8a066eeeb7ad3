#pragma once

#include <span>

#include "model/bodies/body_outline.hpp"
#include "model/model.hpp"
#include "results/file/hdf5_objects.hpp"

namespace gxrod {

// Writes, once for all frames, the group /bodies: the name of each body, the point of /VTKHDF that carries
// it, and its outline at t = 0. Writes nothing without bodies, or if the file has it already. Throws
// Hdf5Error.
void write_outline_table(const Hdf5Handle& root, const Model& model, std::span<const BodyOutline> outlines);

}  // namespace gxrod
