#pragma once

#include "deck/places/build_context.hpp"

namespace gxrod {

// The axes whose directions x, y and z are three rows, the value of a field of the table; the global axes if
// they are invalid, with a fault of this field.
Quat find_axes(const TableHead& table, const void* field, const Mat3& rows, const BuildContext& context);
// The same of a field that can be left out, which means the global axes.
Quat find_axes(const TableHead& table, const std::optional<Mat3>& field, const BuildContext& context);

}  // namespace gxrod
