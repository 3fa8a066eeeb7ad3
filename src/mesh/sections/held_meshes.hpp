#pragma once

#include <optional>

#include "mesh/sections/boundary_division.hpp"
#include "mesh/sections/plane_triangles.hpp"

namespace gxrod {

// While one lives, outlines that differ little from one that was meshed before in this process get the cells
// of that one, moved: so that stiffness is a smooth function of a shape's numbers. For this thread.
class HeldMeshes {
  public:
    HeldMeshes();
    ~HeldMeshes();
    HeldMeshes(const HeldMeshes&) = delete;
    HeldMeshes& operator=(const HeldMeshes&) = delete;

    static bool are_on();
};

// Triangles of an outline, which must outlive them, and the division of its boundary.
struct OutlineTriangles {
    BoundaryDivision boundary;
    PlaneTriangles triangles;
};

// Remembers the triangles of an outline.
void remember_triangles(const Outline& outline, const OutlineTriangles& mesh);

// Finds the triangles of the nearest outline that was meshed before, with as many pieces of each kind, and
// moves them; nullopt if none is near. Points inside move as a membrane fixed to the boundary would.
std::optional<OutlineTriangles> move_remembered(const Outline& outline, const SectionMeshSize& size);

}  // namespace gxrod
