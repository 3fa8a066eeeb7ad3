#pragma once

#include <string>
#include <string_view>

#include "mesh/line_mesh.hpp"

namespace gxrod {

// Writes a mesh as bytes for another process of this program.
std::string write_mesh_bytes(const LineMesh& mesh);
// Reads such a mesh; throws MeshError if these are not all its bytes.
LineMesh read_mesh_bytes(std::string_view bytes);

}  // namespace gxrod
