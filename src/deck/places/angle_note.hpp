#pragma once

#include <string>

namespace gxrod {

// Describes an angle beyond a turn, which may have been meant in degrees; "" for others.
std::string describe_many_turns(double angle);

}  // namespace gxrod
