#pragma once

#include "cross_section/section_mesh.hpp"

namespace gxrod {

// Returns the same cells with an order one higher, for an estimate of the error: their sides stay where they
// are. Orders go up to 4, so that those of the mesh are at most 3.
SectionMesh raise_order(const SectionMesh& mesh);

}  // namespace gxrod
