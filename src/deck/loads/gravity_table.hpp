#pragma once

#include "deck/loads/acting.hpp"
#include "deck/table/table.hpp"

// The key `gravity` of a deck, with a factor and stages.
namespace gxrod {

struct GravityTable : ActingTable {
    CheckedTimeVector acceleration;
};

const TableSpec& gravity_table();

// Returns the acceleration that a deck gives; nullptr without gravity.
const CheckedTimeVector* find_gravity(const CheckedTable& deck);

// Finds how gravity acts in the stage at hand.
Acting find_gravity_acting(const BuildContext& context);

}  // namespace gxrod
