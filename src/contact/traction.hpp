#pragma once

#include <array>

#include "model/contact_friction.hpp"
#include "rotation/types.hpp"

// Coulomb friction between two touching surfaces: it sticks elastically, up to the cone
// (docs/theory/contact.md, (C5)).
namespace gxrod {

// The state of friction: by the law, or assumed by an iteration to stick or to slide, whatever the slip is
// now.
enum class Slip { by_law, sticks, slides };

// Friction with the traction of the last accepted step.
struct CoulombFriction {
    double coefficient = 0.0;
    double stiffness = 0.0;  // elastic stiffness while it sticks
    Vec3 traction = Vec3::Zero();
    Slip slip = Slip::by_law;
    Vec3 direction = Vec3::Zero();  // unit vector against the slip, if it is assumed to slide
    // How the coefficient depends on direction and speed; nullptr if it does not.
    const FrictionShape* shape = nullptr;
    // Unit vectors along the first line, and along the second one reversed; zero for bodies and surfaces.
    std::array<Vec3, 2> axes{Vec3::Zero(), Vec3::Zero()};
    double elapsed = 0.0;  // time since the last accepted step; 0 where nothing has a speed

    bool acts(double normal_force) const { return coefficient > 0.0 && normal_force > 0.0; }
};

// The traction for a pull: the traction if the surfaces stuck, not yet projected on them; `normal` has length
// 1.
struct Traction {
    Vec3 value = Vec3::Zero();
    bool slides = false;
};
Traction compute_traction(const Vec3& pull,
                          const Vec3& normal,
                          double normal_force,
                          const CoulombFriction& friction);

struct TractionDerivative {
    Mat3 by_pull = Mat3::Zero();
    Mat3 by_normal = Mat3::Zero();
    Vec3 by_force = Vec3::Zero();
    // Other than zero only where the coefficient depends on direction or speed.
    std::array<Mat3, 2> by_axes{Mat3::Zero(), Mat3::Zero()};
    Mat3 by_traction = Mat3::Zero();  // by the traction of the last accepted step, for the same pull
};
TractionDerivative compute_traction_derivative(const Vec3& pull,
                                               const Vec3& normal,
                                               double normal_force,
                                               const CoulombFriction& friction);

// Decides what the next iteration assumes, if its increments lead to this pull and normal force, both to
// first order: sticking beyond the cone becomes sliding, sliding against the traction becomes sticking.
CoulombFriction decide_slip(const Vec3& pull,
                            const Vec3& normal,
                            double normal_force,
                            CoulombFriction friction);

}  // namespace gxrod
