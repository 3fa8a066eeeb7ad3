#pragma once

#include "deck/places/build_context.hpp"

namespace gxrod {

// Whether a section has a law, of its table, its material or its twist.
bool has_law(const CheckedTable& section);

// Gives a section whose stiffness is known its law; the stiffness is then that of small strains after a long
// time. What is wrong goes to the faults.
void set_law(const CheckedTable& table, Section& section, const BuildContext& context);

}  // namespace gxrod
