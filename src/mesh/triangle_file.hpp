#pragma once

#include <filesystem>
#include <string>

#include "model/contact.hpp"

namespace gxrod {

// Whether a name ends like that of an STL file.
bool is_stl(const std::filesystem::path& file);

// The triangles of a file, times a scale: STL, as text or bytes, by its own reader; .msh of any version
// through libgmsh, whose quadrangles and triangles of six nodes are cut. Corners at the same place become
// one; triangles without area, and such as are there already, are left out. Throws MeshError.
TriangleMesh read_triangle_mesh(const std::filesystem::path& file, double scale);

// The bytes of a file. Throws MeshError if it is not a regular one.
std::string read_mesh_file(const std::filesystem::path& file);

}  // namespace gxrod
