#pragma once

#include <string_view>

namespace gxrod {

// Whether a name is of the form of a pattern, in which each * stands for any letters, or none.
bool matches_pattern(std::string_view name, std::string_view pattern);

}  // namespace gxrod
