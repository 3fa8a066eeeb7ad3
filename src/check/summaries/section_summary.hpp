#pragma once

#include <string>

#include "model/model.hpp"

namespace gxrod {

// Describes the centres of a section and its principal axes, in lines, if they are not at the node and along
// y and z; else "".
std::string describe_centres(const Section& section);

// Describes them at the ends of a rod whose section varies, and their extremes in between.
std::string describe_varying_centres(const Rod& rod);

}  // namespace gxrod
