#include "mesh/sections/section_mesher.hpp"

#include "mesh/sections/curved_triangles.hpp"
#include "mesh/sections/flat_ears.hpp"
#include "mesh/sections/held_meshes.hpp"

namespace gxrod {

namespace {

OutlineTriangles divide(const Outline& outline, const SectionMeshSize& size, const GmshLibrary& gmsh) {
    if (HeldMeshes::are_on()) {
        if (std::optional<OutlineTriangles> moved = move_remembered(outline, size)) return std::move(*moved);
    }
    OutlineTriangles mesh{divide_boundary(outline, size), {}};
    std::vector<PlaneLoop> loops;
    for (const BoundaryEdges& edges : mesh.boundary.loops) {
        PlaneLoop& loop = loops.emplace_back();
        for (const BoundaryEdge& edge : edges) {
            loop.corners.push_back(edge.start());
            loop.sizes.push_back(edge.size);
        }
    }
    mesh.triangles = mesh_area(loops, gmsh);
    divide_flat_ears(mesh.triangles);
    remember_triangles(outline, mesh);
    return mesh;
}

}  // namespace

SectionMesh mesh_outline(const Outline& outline,
                         const std::string& layer,
                         int order,
                         const SectionMeshSize& size,
                         const GmshLibrary& gmsh) {
    const OutlineTriangles divided = divide(outline, size, gmsh);
    SectionMesh mesh = bend_triangles(divided.triangles, divided.boundary.loops, order);
    mesh.layers = {{.name = layer}};
    mesh.sharp_corners = divided.boundary.sharp_corners;
    return mesh;
}

}  // namespace gxrod
