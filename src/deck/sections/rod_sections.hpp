#pragma once

#include <vector>

#include "deck/places/build_context.hpp"
#include "deck/rods/rod_table.hpp"
#include "deck/sections/section_files.hpp"

// The section of a rod, or its sections that vary along it.
namespace gxrod {

// A section at a fraction of the rod's length: one of the model, or one from a file.
struct Station {
    double fraction;
    int section = 0;
    const Section* of_file = nullptr;  // in place of `section`
};

// Finds the stations from start to end; a single one for a constant section. `file` belongs to the rod and
// must outlive them; nullptr if there is none. If a section is wrong, adds a fault and uses the first section
// of the model.
std::vector<Station> find_stations(const RodTable& rod, const SectionFile* file, BuildContext& context);

// Finds fractions at which the section jumps, so that a node has to be there.
std::vector<double> find_jumps(const std::vector<Station>& stations);

// A part of a rod with one section, or the middle of a part so short that its section may stand for it.
struct SectionPart {
    double first, last;  // fractions of the length
    Section section;
};

// Cuts a rod into such parts, and at these fractions.
std::vector<SectionPart> list_section_parts(const std::vector<Station>& stations,
                                            const Rod& rod,
                                            std::vector<double> fractions,
                                            const BuildContext& context);

// Lists the force points of an element, as fractions of its length.
std::vector<double> list_force_points(int order);

// Gives a rod its section, or sections at the points of its elements, linear between stations. Elements meet
// at these fractions.
void set_sections(const std::vector<Station>& stations,
                  const std::vector<double>& element_fractions,
                  Rod& rod,
                  BuildContext& context);

}  // namespace gxrod
