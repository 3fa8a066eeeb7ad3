#pragma once

#include "rotation/types.hpp"

// Measures of a stress that do not depend on its axes. Components are in the order xx yy zz yz xz xy, or 11
// 22 33 23 13 12.
namespace gxrod {

double compute_von_mises(const Vec6& stress);

// Computes the principal stresses, the largest first.
Vec3 compute_principal_stresses(const Vec6& stress);

}  // namespace gxrod
