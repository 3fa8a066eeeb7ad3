#pragma once

#include "deck/places/build_context.hpp"
#include "deck/surroundings/surroundings_files.hpp"
#include "deck/surroundings/surroundings_tables.hpp"

namespace gxrod {

// Builds the ground from its table; `grid` comes from its file. Errors become faults.
Seabed find_seabed(const SeabedTable& given,
                   const std::optional<GroundGrid>& grid,
                   const BuildContext& context);

// Finds the height of a horizontal ground; nullopt for other grounds or without one.
std::optional<double> find_bed_height(const CheckedTable& deck);

}  // namespace gxrod
