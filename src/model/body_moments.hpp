#pragma once

#include "rotation/types.hpp"

// Checks of the principal moments of inertia of a body, in rising order: the largest is at most the sum of
// the others, since it is ∫(y² + z²) dm and they are ∫(z² + x²) dm and ∫(x² + y²) dm. And what has them.
namespace gxrod {

// Whether the largest exceeds the sum of the others by more than round-off. Equations of motion are well
// defined all the same.
bool exceed_sum(const Vec3& moments);

// Whether it exceeds the sum by more than rounding of moments to two digits can explain: 5 % of each.
bool is_beyond_rounding(const Vec3& moments);

// A homogeneous cuboid about a centre of mass.
struct Cuboid {
    Quat axes = Quat::Identity();    // of its edges, in body axes
    Vec3 half_sizes = Vec3::Zero();  // 0 without a mass
};

// Finds the cuboid of this mass and inertia about its centre (3×3, body axes, symmetric): a² = 3/2 (I_b + I_c
// − I_a)/m for half the edge along a. Axes of a diagonal inertia keep their order.
Cuboid find_cuboid(double mass, const Mat3& inertia);

}  // namespace gxrod
