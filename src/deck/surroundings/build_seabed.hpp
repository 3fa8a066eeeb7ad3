#pragma once

#include "deck/places/build_context.hpp"
#include "deck/surroundings/surroundings_files.hpp"

namespace gxrod {

// The ground by its table; `grid` is that of its file. What is wrong goes to the faults.
Seabed find_seabed(const CheckedTable& table,
                   const std::optional<GroundGrid>& grid,
                   const BuildContext& context);

// The height of a horizontal ground; nullopt of any other, or without one.
std::optional<double> find_bed_height(const CheckedTable& deck);

}  // namespace gxrod
