#pragma once

#include <optional>
#include <string>

#include "deck/places/build_context.hpp"

namespace gxrod {

// Adds a fault to a key of a table unless it is the word of a failure criterion.
void check_criterion(const TableHead& table,
                     const std::optional<std::string>& key,
                     const BuildContext& context);

// Returns whether the deck asks for stresses, in [output] or a history, so that all shapes need cells.
bool asks_for_stresses(const CheckedTable& deck);

}  // namespace gxrod
