#pragma once

#include <vector>

#include "cross_section/walls/wall_outline.hpp"

namespace gxrod {

// A point of the right side of a wall and one of its left side, and all between them.
struct WallCut {
    PlanePoint right = PlanePoint::Zero(), left = PlanePoint::Zero();

    PlanePoint at(double across) const { return right + across * (left - right); }
};

// A piece of a wall with one layup: a quadrilateral between two cuts, or a part of a ring. Places in it are
// given by `along`, from 0 to 1 along the walk, and `across`, from 0 on the right to 1 on the left.
struct WallPiece {
    std::size_t side = 0;
    WallCut start = {}, end = {};
    PlanePoint direction = PlanePoint::Zero();  // of a straight piece, t
    // of an arc: from `from_angle` about the centre, anticlockwise positive
    PlanePoint centre = PlanePoint::Zero();
    double from_angle = 0.0, turn = 0.0;
    double right_radius = 0.0, left_radius = 0.0;
    bool starts_sharply = false, ends_sharply = false;  // at a mitre, a free edge or another layup

    bool is_arc() const { return turn != 0.0; }
    // Returns the length half-way across.
    double length() const;
    PlanePoint at(double along, double across) const;
    // Returns the unit vector t.
    PlanePoint wall(double along) const;
};

// The corner of a wall, between the side before it and the side after it.
struct WallTurn {
    double angle = 0.0;               // from the side before to the one after, anticlockwise positive
    double trim = 0.0;                // how much of either side an arc takes
    WallCut before = {}, after = {};  // where the straight parts of the sides end and begin
};

// Returns the offset of a side's right surface from the line, to the left positive.
double right_offset(WallSide line, double thickness);

// Returns the unit vector of a side.
PlanePoint side_direction(const WallOutline& outline, std::size_t side);

// Returns the turn at a corner, which lies between two sides.
WallTurn find_wall_turn(const WallOutline& outline, const std::vector<Layup>& layups, std::size_t corner);

// Cuts walls without a fault into pieces, in the order of the walk. The middle of an arc parts the layups of
// its two sides.
std::vector<WallPiece> list_wall_pieces(const WallOutline& outline, const std::vector<Layup>& layups);

}  // namespace gxrod
