#include "cross_section/walls/quad_grid.hpp"

namespace gxrod {

SectionCell QuadGrid::cell_at(int along, int across) const {
    SectionCell cell;
    cell.shape = CellShape::quad;
    cell.order = order;
    for (int j = 0; j <= order; ++j) {
        for (int i = 0; i <= order; ++i) cell.nodes.push_back(node(along * order + i, across * order + j));
    }
    return cell;
}

}  // namespace gxrod
