#pragma once

#include <array>
#include <vector>

#include "cross_section/section_mesh.hpp"
#include "mesh/gmsh_library.hpp"

namespace gxrod {

// A polygon around an area or around a hole in it; with the size of elements at each corner.
struct PlaneLoop {
    std::vector<PlanePoint> corners;
    std::vector<double> sizes;
};

// Triangles of an area, walked anticlockwise. The first points are the corners of the loops, in their order;
// each side is a side of one triangle.
struct PlaneTriangles {
    std::vector<PlanePoint> points;
    std::vector<std::array<int, 3>> triangles;
};

// Meshes the area between the first loop and the others. Throws MeshError.
PlaneTriangles mesh_area(const std::vector<PlaneLoop>& loops, const GmshLibrary& gmsh = gmsh_library());

}  // namespace gxrod
