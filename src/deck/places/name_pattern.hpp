#pragma once

#include <string_view>

namespace gxrod {

// Returns whether a name matches a pattern, in which each * stands for any letters, or none.
bool matches_pattern(std::string_view name, std::string_view pattern);

}  // namespace gxrod
