#pragma once

#include <string>

#include "deck/places/build_context.hpp"

namespace gxrod {

// A place along a rod; without a rod, the start of any.
struct SectionPlace {
    double s = 0.0;  // arc length
    std::string rod = {};
};

// Adds the sections to the model, with their values at the start of a rod.
void build_sections(BuildContext& context);

// Return whether a section has functions of s, and the section at a place.
bool varies_along_rod(const CheckedTable& section);
Section build_section(const CheckedTable& section, const SectionPlace& at, const BuildContext& context);

// Returns a number of a table within a section's table, at a place along a rod. Adds a fault if it is out of
// range there or not a number.
double number_of(const CheckedTable& table,
                 const char* key,
                 const SectionPlace& at,
                 const BuildContext& context);

// Gives a section the damping of a table with the key: a [section.NAME] or `sections` of a rod.
void set_damping(const CheckedTable& table, Section& section);

}  // namespace gxrod
