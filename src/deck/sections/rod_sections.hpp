#pragma once

#include <vector>

#include "deck/build/build_context.hpp"

// The section of a rod, or those that vary along it.
namespace gxrod {

// A section of the model at a fraction of the rod's length.
struct Station {
    double fraction;
    int section;
};

// From start to end; one alone of a constant section. What is wrong goes to the faults, and the first section
// of the model takes its place.
std::vector<Station> find_stations(const CheckedTable& rod, BuildContext& context);

// Fractions at which the section jumps, so that a node has to be there.
std::vector<double> find_jumps(const std::vector<Station>& stations);

// Gives a rod its section or, linear between stations, those of the points of its elements, which meet at
// these fractions.
void set_sections(const std::vector<Station>& stations,
                  const std::vector<double>& element_fractions,
                  Rod& rod,
                  BuildContext& context);

}  // namespace gxrod
