#pragma once

#include "contact/traction.hpp"
#include "rotation/types.hpp"

// The contact force between a place of a round rod and a surface, per unit weight (docs/theory/contact.md,
// (C4) to (C6)).
namespace gxrod {

// The geometry of a place against a surface.
struct SurfaceTouch {
    double gap = 0.0;               // between the surfaces
    Vec3 normal = Vec3::Zero();     // from the surface to the place, of length 1
    Mat3 curvature = Mat3::Zero();  // second derivative of the gap by the place
    Vec3 drift = Vec3::Zero();      // displacement of the surface there since the last accepted step
    double slope = 1.0;             // length of the gap's gradient, which is along the normal
};

// A place on the line of a rod, and its motion since the last accepted step.
struct PlaceMotion {
    Vec3 displacement = Vec3::Zero();
    Vec3 rotation = Vec3::Zero();  // a rotation vector
    double radius = 0.0;           // from the line to the surface of the rod
};

// The force λ, and D = −dλ/dg.
struct NormalForce {
    double force = 0.0;
    double stiffness = 0.0;
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
                               const CoulombFriction& friction);

// Applies decide_slip() to a place.
CoulombFriction advance_slip(const SurfaceTouch& touch,
                             const PlaceMotion& place,
                             const NormalForce& normal,
                             const CoulombFriction& friction);

// Derivatives by the place's position and rotation vector.
struct PlaceForceDerivative {
    Mat3 force_by_position = Mat3::Zero();
    Mat3 force_by_rotation = Mat3::Zero();
    Mat3 moment_by_position = Mat3::Zero();
    Mat3 moment_by_rotation = Mat3::Zero();
    Mat3 force_by_axis = Mat3::Zero();  // by the unit vector along the rod, CoulombFriction::axes
    Mat3 moment_by_axis = Mat3::Zero();
};
PlaceForceDerivative compute_place_force_derivative(const SurfaceTouch& touch,
                                                    const PlaceMotion& place,
                                                    const NormalForce& normal,
                                                    const CoulombFriction& friction);

// Computes the derivative of the traction by the normal force.
Vec3 compute_traction_by_force(const SurfaceTouch& touch,
                               const PlaceMotion& place,
                               const NormalForce& normal,
                               const CoulombFriction& friction);

}  // namespace gxrod
