#pragma once

#include <string>

#include "mesh/triangles/triangle_examination.hpp"

namespace gxrod {

// Draws a mesh as SVG: seen along z, y and x, at one scale, with open edges in red.
std::string draw_mesh(const TriangleMesh& mesh, const TriangleExamination& examination);

}  // namespace gxrod
