#pragma once

#include <optional>
#include <string>
#include <vector>

#include "cross_section/section_mesh.hpp"

// Outlines of cross-sections: closed chains of straight pieces and arcs around an area with holes.
namespace gxrod {

// A corner of a polygon; with a radius an arc, that touches both sides, rounds it.
struct OutlineCorner {
    PlanePoint at;
    double radius = 0.0;
};
using CornerChain = std::vector<OutlineCorner>;  // closed: the last corner goes on to the first

// A polygon as a deck gives it: chains walked in either direction.
struct Polygon {
    CornerChain outer;
    std::vector<CornerChain> holes = {};
};

// A straight piece, or an arc.
struct OutlinePiece {
    PlanePoint from, to;
    PlanePoint centre = PlanePoint::Zero();  // of an arc
    double turn =
        0.0;         // from `from` to `to` about the centre, anticlockwise positive, |turn| < π; 0: straight
    int corner = 0;  // of the chain: the one rounded by an arc, or from which a straight piece comes
    int next = 0;    // the corner to which a straight piece goes

    bool is_arc() const { return turn != 0.0; }
    double length() const;
    // Returns the point at a fraction of the length.
    PlanePoint at(double fraction) const;
    // Returns the unit vector along the walk at a fraction of the length.
    PlanePoint direction(double fraction) const;
};
using OutlineLoop = std::vector<OutlinePiece>;

// The area is to the left of every loop: the outer one is walked anticlockwise, holes clockwise.
struct Outline {
    OutlineLoop outer;
    std::vector<OutlineLoop> holes = {};

    // Returns the outer loop and the holes.
    std::vector<const OutlineLoop*> loops() const;
};

// A fault of a shape: the part of it, such as "outer[3]" or "flange", and the message. The hole of a
// polygon, and the corner of its outer chain or of the hole, if the part has them.
struct OutlineFault {
    std::string part;
    std::string message;
    std::optional<std::size_t> hole = std::nullopt;
    std::optional<std::size_t> corner = std::nullopt;
};

// Rounds the corners of a chain; the loop has the chain's direction. A rounded corner without a turn stays as
// it is.
OutlineLoop round_corners(const CornerChain& chain);

// Draws a polygon, walked as an outline is, whatever the directions of its chains.
Outline draw_outline(const Polygon& polygon);

// Draws a ring, or, with an inner radius 0, a circle; the centre is (0, 0).
Outline draw_ring(double outer_radius, double inner_radius);

// Moves an outline.
Outline move_outline(Outline outline, const PlanePoint& by);

// Scales an outline about (0, 0).
Outline scale_outline(Outline outline, double factor);

// Returns a × b: positive if b is to the left of a.
inline double cross(const PlanePoint& a, const PlanePoint& b) { return a.x() * b.y() - a.y() * b.x(); }

// Returns the area of a chain without its radii, positive if it is walked anticlockwise.
double compute_signed_area(const CornerChain& chain);

// How much of the sides next to a corner its arc takes.
double compute_tangent_length(const CornerChain& chain, std::size_t corner);

}  // namespace gxrod
