#pragma once

#include "cross_section/outlines/outline.hpp"

namespace gxrod {

// The place across a wall from a point of the boundary.
struct OppositeWall {
    const OutlinePiece* piece = nullptr;
    double fraction = 0.0;  // of the piece's length
    double thickness = 0.0;
};

// Finds the wall that a point of a piece faces: the first piece that the inward normal meets. Nothing if that
// is not a wall about parallel, as at the end of a flange or next to a corner.
std::optional<OppositeWall> find_opposite_wall(const Outline& outline,
                                               const OutlinePiece& piece,
                                               double fraction);

}  // namespace gxrod
