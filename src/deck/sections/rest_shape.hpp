#pragma once

#include <functional>

#include "deck/build/build_context.hpp"
#include "geometry/centreline.hpp"

// The shape in which a rod is free of stress, where that is not the one in which it starts.
namespace gxrod {

// A rod as the deck draws it.
struct DrawnRod {
    const Centreline& line;
    std::function<Quat(std::size_t piece, double fraction)> axes;  // of the section
};

// Gives a rod the strains that its start has against its rest, of elements that meet at these fractions of
// its length; none if the deck's table says nothing of a rest and the rod is no hung line. What is wrong goes
// to the faults.
void set_rest(const CheckedTable& table,
              const DrawnRod& drawn,
              const std::vector<double>& element_fractions,
              Rod& rod,
              const BuildContext& context);

}  // namespace gxrod
