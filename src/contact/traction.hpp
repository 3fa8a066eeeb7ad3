#pragma once

#include "rotation/types.hpp"

// Coulomb's friction between two surfaces that touch: it sticks elastically, up to the cone
// (docs/theory/contact.md, (C5)).
namespace gxrod {

// Whether friction holds follows from the law; or an iteration takes it for granted, whatever the slip is
// now.
enum class Slip { by_law, sticks, slides };

// With the traction of the last accepted step.
struct CoulombFriction {
    double coefficient = 0.0;
    double stiffness = 0.0;  // of what sticks
    Vec3 traction = Vec3::Zero();
    Slip slip = Slip::by_law;
    Vec3 direction = Vec3::Zero();  // of the traction of what is taken to slide, of length 1

    bool acts(double normal_force) const { return coefficient > 0.0 && normal_force > 0.0; }
};

// The pull is the traction if the surfaces stuck, not yet projected on them; `normal` has length 1.
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
};
TractionDerivative compute_traction_derivative(const Vec3& pull,
                                               const Vec3& normal,
                                               double normal_force,
                                               const CoulombFriction& friction);

// What an iteration is to take for granted next, when its increments lead to this pull and normal force, both
// to first order: what sticks beyond the cone slides, what slides against its traction sticks.
CoulombFriction decide_slip(const Vec3& pull,
                            const Vec3& normal,
                            double normal_force,
                            CoulombFriction friction);

}  // namespace gxrod
