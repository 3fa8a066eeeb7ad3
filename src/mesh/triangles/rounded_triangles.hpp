#pragma once

#include "model/obstacle_shape.hpp"

namespace gxrod {

// A mesh whose facets were curved and cut into smaller ones, and by how much they stand off the old ones.
struct RoundedTriangles {
    TriangleMesh mesh;
    double depth = 0.0;
};

// Rounds a mesh that approximates a curved surface: over edges that turn by no more than the mesh's feature
// angle the surface becomes smooth, through all corners; sharp edges stay sharp. Each facet becomes a
// quadratic patch through its corners, by the mean normals there (T. Nagata, Simple local interpolation of
// surfaces using normal vectors, Computer Aided Geometric Design 22, 2005; docs/theory/contact.md), and is
// cut into as many as turn by 0.1 rad or more, which touch one by one. What is flat stays as it is.
RoundedTriangles round_triangles(const TriangleMesh& mesh);

}  // namespace gxrod
