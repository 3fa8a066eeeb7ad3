#pragma once

#include "deck/places/build_context.hpp"
#include "deck/surroundings/surroundings_files.hpp"
#include "deck/surroundings/surroundings_tables.hpp"

namespace gxrod {

// Finds the depth for waves, from the table [fluid] or the ground below; nullopt for deep water, or with a
// fault.
std::optional<double> find_depth(const FluidTable& fluid, const BuildContext& context);

// Checks that waves have a surface and a stage in which they act. Errors become faults.
void check_waves(const BuildContext& context);

// Gives water with a surface and a depth the waves of the current stage, if the stage has time; t of waves
// continues from stage to stage. Errors become faults.
void set_waves(const SurroundingsFiles& files, Water& water, const BuildContext& context);

}  // namespace gxrod
