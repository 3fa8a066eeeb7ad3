#pragma once

#include "deck/places/build_context.hpp"
#include "deck/surroundings/surroundings_files.hpp"

namespace gxrod {

// The depth that waves feel, by the table [fluid] or the ground below; nullopt of deep water, or with a
// fault.
std::optional<double> find_depth(const CheckedTable& fluid, const BuildContext& context);

// That waves have a surface, and a stage in which they act; what is wrong goes to the faults.
void check_waves(const BuildContext& context);

// Gives water with a surface and a depth the waves of the stage at hand, if that has time; t of theirs goes
// on from stage to stage. What is wrong goes to the faults.
void set_waves(const SurroundingsFiles& files, Water& water, const BuildContext& context);

}  // namespace gxrod
