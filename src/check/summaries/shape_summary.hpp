#pragma once

#include <string>

#include "cross_section/cross_section.hpp"

namespace gxrod {

// Describes a section that was cut into cells, in lines: what it is, its geometry, its plastic resultants and
// how far restrained warping reaches. Lengths are a deck's.
std::string describe_shape(const CrossSection& section);

}  // namespace gxrod
