#pragma once

#include <string_view>
#include <vector>

namespace gxrod {

// Returns the tables of the catalogue, which CMake compiles in: src/cross_section/catalogue/*.csv. Lines
// "# shape: I" and "# unit: mm" say what the rows are.
const std::vector<std::string_view>& catalogue_texts();

}  // namespace gxrod
