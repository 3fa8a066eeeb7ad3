#pragma once

#include <functional>

#include "deck/places/build_context.hpp"
#include "deck/sections/section_twist.hpp"
#include "geometry/centreline.hpp"
#include "mesh/rod_mesh.hpp"

// The shape in which a rod is free of stress, where that is not the one in which it starts.
namespace gxrod {

// A rod as the deck draws it.
struct DrawnRod {
    const Centreline& line;
    std::function<Quat(std::size_t piece, double fraction)> axes;  // of the section
};

// Another curve, by whose arc length a rod is measured then.
struct RestCurve {
    Centreline line;
    Quat start_axes;
    SectionTwist twist;
};

// The curve that the deck's table has for a rest; nullopt without one, or with a fault. `twist` is the rod's
// own.
std::optional<RestCurve> find_rest_curve(const CheckedTable& table,
                                         const SectionTwist& twist,
                                         BuildContext& context);

// Adds the corners of the rest to those of the start.
void add_corners(const std::vector<double>& corners, RodBreaks& breaks);

// Gives a rod the strains that its start has against its rest, of elements that meet at these fractions of
// its length; none if the deck's table says nothing of a rest and the rod is no hung line. What is wrong goes
// to the faults.
void set_rest(const CheckedTable& table,
              const DrawnRod& drawn,
              const std::vector<double>& element_fractions,
              Rod& rod,
              const BuildContext& context);

// Gives a rod the nodes of a rest that is another curve, and its arc length.
void set_rest(const CheckedTable& table,
              const RestCurve& rest,
              const std::vector<double>& element_fractions,
              Rod& rod,
              const BuildContext& context);

}  // namespace gxrod
