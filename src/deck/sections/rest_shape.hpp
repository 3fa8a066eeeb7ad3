#pragma once

#include <functional>

#include "deck/places/build_context.hpp"
#include "deck/rods/rod_table.hpp"
#include "deck/sections/section_twist.hpp"
#include "geometry/centreline.hpp"
#include "mesh/rod_mesh.hpp"

// The shape in which a rod is free of stress, if it starts in another shape.
namespace gxrod {

// The geometry of a rod in the deck.
struct DrawnRod {
    const Centreline& line;
    std::function<Quat(std::size_t piece, double fraction)> axes;  // axes of the section
};

// Another curve as the stress-free shape; the rod's arc length is then measured along it.
struct RestCurve {
    Centreline line;
    std::vector<Quat> piece_axes;  // carried back from each of its pieces to the start
    SectionTwist twist;
};

// Finds the axes from which those along each piece of a line follow, as `transport` of the line carries them:
// by a rule for each piece, else the same for all. Of wrong ones a fault, and nullopt.
std::optional<std::vector<Quat>> find_piece_axes(const TableHead& table,
                                                 const SectionDirections& directions,
                                                 const Centreline& line,
                                                 BuildContext& context);

// Finds the rest curve of the deck's table; nullopt if there is none, or with a fault. `twist` is the rod's
// own.
std::optional<RestCurve> find_rest_curve(const RodTable& table,
                                         const SectionTwist& twist,
                                         BuildContext& context);

// Makes the straight rest of a line that is drawn as it stretches.
RestCurve make_straight_rest(double length, const SectionTwist& twist);

// Adds the corners of the rest shape to the corners of the start.
void add_corners(const std::vector<double>& corners, RodBreaks& breaks);

// Gives a rod the strains of its start relative to its rest shape, for elements that meet at these fractions
// of its length; none if the deck's table has no rest shape and the rod is not a hung line. Errors become
// faults.
void set_rest(const RodTable& table,
              const DrawnRod& drawn,
              const std::vector<double>& element_fractions,
              Rod& rod,
              const BuildContext& context);

// Gives a rod the nodes of a rest curve and its arc length.
void set_rest(const RodTable& table,
              const RestCurve& rest,
              const std::vector<double>& element_fractions,
              Rod& rod,
              const BuildContext& context);

}  // namespace gxrod
