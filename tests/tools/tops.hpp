#pragma once

#include "model/model.hpp"

// Rigid bodies with reference motions, computed by an 8th-order Runge-Kutta scheme and elliptic functions.
namespace gxrod::tools {

// A free body at rest in place whose body axes are the global ones at t = 0; angular velocity in either.
Model make_free_body(const Vec3& inertia, const Vec3& angular_velocity);

// Heavy top of Brüls, Cardona & Arnold (2012): node at the pivot, centre of mass at (0, 1, 0).
namespace heavy_top {
Model make_model();
Vec3 centre_of_mass(const Quat& Lambda);
struct Reference {
    double time;
    Vec3 centre_of_mass;
};
// At t = 0.2, 1 and 2; known to 4e-11.
const std::vector<Reference>& references();
Quat reference_rotation();  // at t = 2
}  // namespace heavy_top

// Fast top of Simo & Wong (1991): node at the pivot, axis e₃ of the body.
namespace fast_top {
Model make_model();
Vec3 axis(const Quat& Lambda);
Vec3 reference_axis_1();                             // at t = 1
Vec3 reference_axis_10();                            // at t = 10
inline constexpr double energy = 1269.106729782512;  // with the potential from the pivot's height
}  // namespace fast_top

}  // namespace gxrod::tools
