#pragma once

#include "rotation/types.hpp"

// The force with which a place of a round rod and a surface touch, per unit weight
// (docs/theory/contact.md, (C4) to (C6)).
namespace gxrod {

// Where a place is against a surface.
struct SurfaceTouch {
    double gap = 0.0;               // between the surfaces
    Vec3 normal = Vec3::Zero();     // from the surface to the place, of length 1
    Mat3 curvature = Mat3::Zero();  // second derivative of the gap by the place
    Vec3 drift = Vec3::Zero();      // how the surface moved there since the last accepted step
    double slope = 1.0;             // length of the gap's gradient, which is along the normal
};

// A place on the line of a rod, and how it moved since the last accepted step.
struct PlaceMotion {
    Vec3 displacement = Vec3::Zero();
    Vec3 rotation = Vec3::Zero();  // a rotation vector
    double radius = 0.0;           // from the line to the surface of the rod
};

// λ, and D = −dλ/dg.
struct NormalForce {
    double force = 0.0;
    double stiffness = 0.0;
};

// Whether friction holds follows from the law; or an iteration takes it for granted, whatever the slip is
// now.
enum class Slip { by_law, sticks, slides };

// Coulomb's friction that sticks elastically, and the traction of the last accepted step.
struct PlaceFriction {
    double coefficient = 0.0;
    double stiffness = 0.0;  // of what sticks, per unit weight
    Vec3 traction = Vec3::Zero();
    Slip slip = Slip::by_law;
    Vec3 direction = Vec3::Zero();  // of the traction of what is taken to slide, of length 1
};

struct PlaceForce {
    Vec3 force = Vec3::Zero();
    Vec3 moment = Vec3::Zero();    // about the line
    Vec3 traction = Vec3::Zero();  // the part of the force that is friction
    bool slides = false;
};
PlaceForce compute_place_force(const SurfaceTouch& touch,
                               const PlaceMotion& place,
                               const NormalForce& normal,
                               const PlaceFriction& friction);

// What an iteration is to take for granted next, when its increments lead to this motion and normal force,
// both to first order: what sticks beyond the cone slides, what slides against its traction sticks.
PlaceFriction advance_slip(const SurfaceTouch& touch,
                           const PlaceMotion& place,
                           const NormalForce& normal,
                           PlaceFriction friction);

// By the place's position and rotation vector.
struct PlaceForceDerivative {
    Mat3 force_by_position = Mat3::Zero();
    Mat3 force_by_rotation = Mat3::Zero();
    Mat3 moment_by_position = Mat3::Zero();
    Mat3 moment_by_rotation = Mat3::Zero();
};
PlaceForceDerivative compute_place_force_derivative(const SurfaceTouch& touch,
                                                    const PlaceMotion& place,
                                                    const NormalForce& normal,
                                                    const PlaceFriction& friction);

}  // namespace gxrod
