#pragma once

#include <Eigen/Core>
#include <string>
#include <vector>

// A cross-section cut into cells, triangles and quadrilaterals of one order or several. Coordinates are (y,
// z) in the axes of the section, as long as a deck's; x points along the rod.
namespace gxrod {

using PlanePoint = Eigen::Vector2d;  // (y, z)

enum class CellShape { triangle, quad };

// Cells that have one material, whose fibres have one angle to x, and one name in results: a ply, or a group
// of a mesh. The fibres, axis 1 of the material, lie along cos θ x + sin θ t, where t is the direction of the
// wall; axis 3 is n = x × t, axis 2 completes them.
struct SectionLayer {
    std::string name;
    int material = 0;          // an index in the materials that go with the mesh
    double fibre_angle = 0.0;  // θ
};

// A cell with Lagrange shape functions on an even lattice. Its nodes go row by row: of a triangle the point
// (i, j) of the lattice has 0 ≤ j ≤ order, 0 ≤ i ≤ order − j; of a quadrilateral both run from 0 to order; i
// runs fastest. The area is to the left of a walk from corner to corner: (0, 0), (order, 0), then (0, order)
// or (order, order).
struct SectionCell {
    CellShape shape = CellShape::triangle;
    int order = 1;
    int layer = 0;                  // an index in SectionMesh::layers
    std::vector<int> nodes;         // indices in SectionMesh::nodes
    std::vector<PlanePoint> walls;  // the unit vector t at each node; empty: t is y everywhere
};

// A re-entrant corner without a radius, where stresses have no bound: points within `reach` of it have no
// part in largest values.
struct SharpCorner {
    PlanePoint at;
    double reach;
};

struct SectionMesh {
    std::vector<PlanePoint> nodes;
    std::vector<SectionCell> cells;
    std::vector<SectionLayer> layers;
    std::vector<SharpCorner> sharp_corners = {};
};

// Returns the number of nodes of a cell.
constexpr int count_nodes(CellShape shape, int order) {
    return shape == CellShape::triangle ? (order + 1) * (order + 2) / 2 : (order + 1) * (order + 1);
}

}  // namespace gxrod
