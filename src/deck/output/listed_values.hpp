#pragma once

#include "deck/places/build_context.hpp"

namespace gxrod {

// The numbers of a table that has their ends, from the first to the last, or lists them.
std::vector<double> list_values(const CheckedTable& table, const BuildContext& context);

}  // namespace gxrod
