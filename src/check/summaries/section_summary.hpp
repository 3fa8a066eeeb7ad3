#pragma once

#include <string>

#include "model/model.hpp"

namespace gxrod {

// Lines for a reader: where the centres of a section are and which axes are its principal ones, where they
// are not at the node and along y and z; "" where all of them are.
std::string describe_centres(const Section& section);

// The same at the ends of a rod whose section varies, and the extremes between.
std::string describe_varying_centres(const Rod& rod);

}  // namespace gxrod
