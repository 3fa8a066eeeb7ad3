#pragma once

#include "cross_section/section_mesh.hpp"

namespace gxrod {

// A grid of quadrilaterals of one order: cells × order columns of nodes along, and across likewise, plus one
// each unless the columns close to a ring.
struct QuadGrid {
    int order = 3;
    int cells_along = 1, cells_across = 1;
    bool is_ring = false;

    int rows() const { return cells_across * order + 1; }
    int columns() const { return cells_along * order + (is_ring ? 0 : 1); }
    int node(int column, int row) const { return column % columns() * rows() + row; }
    // Returns a cell with its nodes, of layer 0.
    SectionCell cell_at(int along, int across) const;
};

}  // namespace gxrod
