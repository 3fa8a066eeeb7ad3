#pragma once

#include "deck/places/build_context.hpp"

namespace gxrod {

// Lists the numbers of a table that gives their ends or lists them.
std::vector<double> list_values(const CheckedTable& table, const BuildContext& context);

}  // namespace gxrod
