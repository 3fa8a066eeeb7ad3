#pragma once

#include <optional>

#include "contact/traction.hpp"

// Friction whose coefficient depends on the direction and the speed of slip (docs/theory/contact.md, (C28) to
// (C30)): what traction.hpp calls where CoulombFriction::shape is given.
namespace gxrod {

// All need a normal force and a coefficient above 0.
Traction compute_shaped_traction(const Vec3& pull,
                                 const Vec3& normal,
                                 double normal_force,
                                 const CoulombFriction& friction);
TractionDerivative compute_shaped_traction_derivative(const Vec3& pull,
                                                      const Vec3& normal,
                                                      double normal_force,
                                                      const CoulombFriction& friction);

// Finds the unit vector against the slip by the law, whatever is assumed; none if it sticks.
std::optional<Vec3> find_shaped_slip(const Vec3& pull,
                                     const Vec3& normal,
                                     double normal_force,
                                     const CoulombFriction& friction);

// Computes the share of the coefficient that is left at a speed, (C30).
double find_share_at_speed(const FrictionShape& shape, double speed);

}  // namespace gxrod
