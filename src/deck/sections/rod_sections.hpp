#pragma once

#include <vector>

#include "deck/places/build_context.hpp"
#include "deck/sections/section_files.hpp"

// The section of a rod, or those that vary along it.
namespace gxrod {

// A section at a fraction of the rod's length: one of the model, or one that a file has there.
struct Station {
    double fraction;
    int section = 0;
    const Section* of_file = nullptr;  // in place of `section`
};

// From start to end; one alone of a constant section. `file` is that of the rod, which must outlive them;
// nullptr without one. What is wrong goes to the faults, and the first section of the model takes its place.
std::vector<Station> find_stations(const CheckedTable& rod, const SectionFile* file, BuildContext& context);

// Fractions at which the section jumps, so that a node has to be there.
std::vector<double> find_jumps(const std::vector<Station>& stations);

// Where the force points of an element are, as fractions of its length.
std::vector<double> list_force_points(int order);

// Gives a rod its section or, linear between stations, those of the points of its elements, which meet at
// these fractions.
void set_sections(const std::vector<Station>& stations,
                  const std::vector<double>& element_fractions,
                  Rod& rod,
                  BuildContext& context);

}  // namespace gxrod
