#pragma once

#include <string>

#include "deck/places/build_context.hpp"

namespace gxrod {

// Where along a rod; without one, at the start of any.
struct SectionPlace {
    double s = 0.0;  // arc length
    std::string rod = {};
};

// Adds the sections to the model, as they are at the start of a rod.
void build_sections(BuildContext& context);

// Whether a section has functions of s; and what it is at a place.
bool varies_along_rod(const CheckedTable& section);
Section build_section(const CheckedTable& section, const SectionPlace& at, const BuildContext& context);

// A number of a table in that of a section, at a place along a rod. One that is out of range there, or no
// number, is a fault.
double number_of(const CheckedTable& table,
                 const char* key,
                 const SectionPlace& at,
                 const BuildContext& context);

// Gives a section the damping of a table that has the key, of a [section.NAME] or of `sections` of a rod.
void set_damping(const CheckedTable& table, Section& section);

}  // namespace gxrod
