#pragma once

#include <vector>

#include "deck/places/build_context.hpp"
#include "mesh/mesh_files.hpp"
#include "model/bodies/body_outline.hpp"

namespace gxrod {

// Builds what each body of the model looks like: by its looks, or without them by the shape with which it
// touches or the cuboid of its mass and inertia, and lines to its joints. Files are added to `records`. Call
// it when the model has all its ties.
std::vector<BodyOutline> build_outlines(const MeshFiles& files,
                                        std::vector<MeshRecord>& records,
                                        const BuildContext& context);

}  // namespace gxrod
