#pragma once

#include "rotation/types.hpp"

// The principal moments of inertia of a body, in rising order: the largest is at most the sum of the others,
// for it is ∫(y² + z²) dm where these are ∫(z² + x²) dm and ∫(x² + y²) dm.
namespace gxrod {

// Whether the largest is above the sum of the others by more than round-off. Equations of motion are well
// defined all the same.
bool exceed_sum(const Vec3& moments);

// Whether it is so by more than moments that are rounded to two digits can be: 5 % of each.
bool is_beyond_rounding(const Vec3& moments);

}  // namespace gxrod
