#pragma once

#include <string>

namespace gxrod {

// "0.3 %", "130 %", and of what is small "2e-07".
std::string describe_share(double share);

}  // namespace gxrod
