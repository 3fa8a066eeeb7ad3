#pragma once

#include <memory>

#include "cross_section/cross_section.hpp"

namespace gxrod {

// Returns a section whose origin lies at a point of other axes, and whose axes are turned from those about x,
// right-handed: from y towards z. Everything it has is then about the origin and in the directions of the
// other axes.
std::shared_ptr<const CrossSection> move_cross_section(std::shared_ptr<const CrossSection> section,
                                                       const PlanePoint& at,
                                                       double turn);

}  // namespace gxrod
