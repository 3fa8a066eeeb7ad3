#pragma once

#include <cstddef>
#include <string>

namespace gxrod {

// Returns a colour "#rrggbb" for a value from 0 to 1, from dark blue through green to yellow.
std::string colour_of_value(double value);

// Returns a colour for one of several groups.
std::string colour_of_group(std::size_t index);

}  // namespace gxrod
