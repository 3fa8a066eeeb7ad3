#pragma once

#include <utility>
#include <vector>

#include "cross_section/section_mesh.hpp"

namespace gxrod {

// A side of a cell: its nodes from corner to corner, with the cell on the left.
struct CellSide {
    int cell = 0;
    std::vector<int> nodes;
};

// Lists the sides of a cell.
std::vector<CellSide> list_cell_sides(const SectionMesh& mesh, int cell);

// The sides of a mesh, sorted by how many cells they have.
struct MeshSides {
    std::vector<CellSide> boundary;               // sides of one cell only
    std::vector<std::pair<int, int>> neighbours;  // cells that share a side
    std::vector<CellSide> repeated;  // sides that lie on the same nodes as two others, or as one the same way
};

MeshSides sort_sides(const SectionMesh& mesh);

}  // namespace gxrod
