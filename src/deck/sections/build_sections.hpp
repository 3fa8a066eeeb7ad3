#pragma once

#include <string>

#include "deck/places/build_context.hpp"
#include "deck/sections/section_tables.hpp"
#include "model/sections/section_frame.hpp"

namespace gxrod {

// A place along a rod; without a rod, the start of any.
struct SectionPlace {
    double s = 0.0;  // arc length
    std::string rod = {};
    double first = 0.0, last = 0.0;  // arc lengths between which the rod has the section
    bool is_node = false;            // of an element, where stresses may be asked for
};

// Adds the sections to the model, with their values at the start of a rod.
void build_sections(BuildContext& context);

// Returns whether a section has functions of s.
bool varies_along_rod(const CheckedTable& section);
// Returns the same of the table that a section was read from.
bool depends_on_place(const SectionTable& section, const BuildContext& context);
// Builds the section at a place.
Section build_section(const SectionTable& given, const SectionPlace& at, const BuildContext& context);

// Gives a section its law at a place, if it has one, and moves its stiffness, which is given in the frame, to
// the rod; with a law it then holds for small strains after a long time. Errors become faults.
void set_law(const SectionTable& given,
             const SectionPlace& at,
             const SectionFrame& frame,
             Section& section,
             const BuildContext& context);

// Returns a number of a table within a section's table, at a place along a rod. Adds a fault if it is out of
// range there or not a number.
double number_of(const TableHead& table,
                 const ArcNumber& given,
                 const SectionPlace& at,
                 const BuildContext& context);

// Returns whether a tube has a wall; adds a fault if not.
bool is_hollow(const TubeTable& tube, double outer, double inner, const BuildContext& context);

// Gives a section its damping: that of a [section.NAME] or of `sections` of a rod.
void set_damping(const DampingTable& given, Section& section);

}  // namespace gxrod
