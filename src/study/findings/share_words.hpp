#pragma once

#include <string>

namespace gxrod {

// Describes a share as "0.3 %", "130 %", or if it is small "2e-07".
std::string describe_share(double share);

}  // namespace gxrod
