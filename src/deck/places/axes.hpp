#pragma once

#include "deck/places/build_context.hpp"

namespace gxrod {

// The key `axes` of a table, or another one, three rows that are the directions x, y and z; the global axes
// without it, and with a fault.
Quat find_axes(const CheckedTable& table, const BuildContext& context, const std::string& key = "axes");

}  // namespace gxrod
