#pragma once

#include <vector>

#include "cross_section/outlines/outline.hpp"

namespace gxrod {

// How large the elements of a section are.
struct SectionMeshSize {
    double per_thickness = 0.5;  // size over the local thickness of the wall
    // At re-entrant corners without a radius; sizes grow by `growth` of the distance.
    double per_thickness_at_corners = 0.03;
    double growth = 0.35;
    double per_extent = 0.2;  // at most, over the section's least extent
};

// An edge of an element on the boundary, part of a piece of the outline.
struct BoundaryEdge {
    const OutlinePiece* piece;
    double from, to;  // fractions of the piece's length
    double size;      // of elements at its start

    PlanePoint start() const { return piece->at(from); }
    // Returns the point at a fraction of the edge.
    PlanePoint at(double fraction) const { return piece->at(from + fraction * (to - from)); }
};
using BoundaryEdges = std::vector<BoundaryEdge>;  // of one loop, each begins where the one before ends

struct BoundaryDivision {
    std::vector<BoundaryEdges> loops;  // the outer one first
    std::vector<SharpCorner> sharp_corners;
};

// Divides the boundary of an outline, which must outlive the division, into edges of elements. Throws
// MeshError if these are too many.
BoundaryDivision divide_boundary(const Outline& outline, const SectionMeshSize& size);

}  // namespace gxrod
