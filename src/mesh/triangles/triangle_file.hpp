#pragma once

#include <filesystem>
#include <string>

#include "model/contact.hpp"

namespace gxrod {

// Whether a file name has the ending of an STL file.
bool is_stl(const std::filesystem::path& file);

// Reads the triangles of a file, times a scale: STL, as text or bytes, by its own reader; .msh of any version
// through libgmsh, with quadrangles and triangles of six nodes cut into triangles. Corners at the same place
// become one; triangles without area, and repeated ones, are left out. Throws MeshError.
TriangleMesh read_triangle_mesh(const std::filesystem::path& file, double scale);

// Reads the bytes of a file. Throws MeshError if it is not a regular one.
std::string read_mesh_file(const std::filesystem::path& file);

}  // namespace gxrod
