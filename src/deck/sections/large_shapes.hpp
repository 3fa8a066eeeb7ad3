#pragma once

#include "deck/reading/checked_deck.hpp"
#include "deck/text/fault_list.hpp"
#include "model/model.hpp"

namespace gxrod {

// Adds a question for each shape on cells that is more than a fifth as large as the rods with it are long,
// each counted with all rods of its part of the model: such a deck often has lengths in two units.
void question_large_shapes(const CheckedTable& deck, const Model& model, FaultList& questions);

}  // namespace gxrod
