#pragma once

#include "rotation/types.hpp"

// Checks of the principal moments of inertia of a body, in rising order: the largest is at most the sum of
// the others, since it is ∫(y² + z²) dm and they are ∫(z² + x²) dm and ∫(x² + y²) dm.
namespace gxrod {

// Whether the largest exceeds the sum of the others by more than round-off. Equations of motion are well
// defined all the same.
bool exceed_sum(const Vec3& moments);

// Whether it exceeds the sum by more than rounding of moments to two digits can explain: 5 % of each.
bool is_beyond_rounding(const Vec3& moments);

}  // namespace gxrod
