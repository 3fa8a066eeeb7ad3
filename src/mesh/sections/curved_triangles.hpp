#pragma once

#include "mesh/sections/boundary_division.hpp"
#include "mesh/sections/plane_triangles.hpp"

namespace gxrod {

// Gives triangles an order: adds nodes on their sides and inside. The points of the mesh begin with the
// starts of the boundary's edges, and sides that are such edges are bent to the outline. The cells have layer
// 0.
SectionMesh bend_triangles(const PlaneTriangles& mesh, const std::vector<BoundaryEdges>& boundary, int order);

}  // namespace gxrod
