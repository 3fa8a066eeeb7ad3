#include "mesh/sections/section_mesher.hpp"

#include "mesh/sections/curved_triangles.hpp"
#include "mesh/sections/flat_ears.hpp"

namespace gxrod {

SectionMesh mesh_outline(const Outline& outline,
                         const std::string& layer,
                         int order,
                         const SectionMeshSize& size,
                         const GmshLibrary& gmsh) {
    const BoundaryDivision boundary = divide_boundary(outline, size);
    std::vector<PlaneLoop> loops;
    for (const BoundaryEdges& edges : boundary.loops) {
        PlaneLoop& loop = loops.emplace_back();
        for (const BoundaryEdge& edge : edges) {
            loop.corners.push_back(edge.start());
            loop.sizes.push_back(edge.size);
        }
    }
    PlaneTriangles triangles = mesh_area(loops, gmsh);
    divide_flat_ears(triangles);
    SectionMesh mesh = bend_triangles(triangles, boundary.loops, order);
    mesh.layers = {{.name = layer}};
    mesh.sharp_corners = boundary.sharp_corners;
    return mesh;
}

}  // namespace gxrod
