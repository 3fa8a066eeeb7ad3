#pragma once

#include <string>
#include <vector>

namespace mu {
class Parser;
}

// Names that every expression of a deck can use.
namespace gxrod {

// Lists the functions as a user writes them.
const std::vector<std::string>& built_in_functions();

// Makes these functions and pi the only names that the parser knows.
void define_built_ins(mu::Parser& parser);

}  // namespace gxrod
