#pragma once

#include "deck/loads/acting.hpp"
#include "deck/surroundings/surroundings_tables.hpp"

// Whether [fluid] and [seabed] are there in a stage, and by how much they count.
namespace gxrod {

// Finds the factor of water or ground in the stage at hand: 0 where it is not there, 1 without the key
// `factor`, also in a first static stage.
TimeFunction find_presence(const ActingTable& given, const BuildContext& context);

// The factor with which the shape of what hangs free of loads at the start is found: at the end of a first
// stage without time, at the start of one with time.
double find_presence_at_start(const ActingTable& given, const BuildContext& context);

// Faults of a factor of the water that changes within the stage at hand while water moves along with what
// moves: its momentum would come out of nothing.
void check_added_mass(const FluidTable& fluid, const TimeFunction& factor, const BuildContext& context);

}  // namespace gxrod
