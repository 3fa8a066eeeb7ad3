#pragma once

#include "deck/sections/section_tables.hpp"
#include "deck/table/table.hpp"

namespace gxrod {

// Adds the keys of shapes that are meshed.
void add_outlined_shapes(Table<ShapeTable>& table);

}  // namespace gxrod
