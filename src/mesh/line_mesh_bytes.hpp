#pragma once

#include <string>
#include <string_view>

#include "mesh/line_mesh.hpp"

namespace gxrod {

// A mesh as it goes from one process of this program to another.
std::string write_mesh_bytes(const LineMesh& mesh);
// Throws MeshError if these are not all bytes of a mesh.
LineMesh read_mesh_bytes(std::string_view bytes);

}  // namespace gxrod
