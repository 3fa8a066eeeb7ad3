#pragma once

#include "deck/places/build_context.hpp"

namespace gxrod {

// Returns whether a section has a law, from its table, its material or its twist.
bool has_law(const CheckedTable& section);

// Gives a section with known stiffness its law; the stiffness then holds for small strains after a long time.
// Errors become faults.
void set_law(const CheckedTable& table, Section& section, const BuildContext& context);

}  // namespace gxrod
