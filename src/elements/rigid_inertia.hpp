#pragma once

#include "state/motion.hpp"

// The inertia of a rigid body about a node that need not be its centre of mass.
//
// Legend: Lambda rotation since t = 0, s = Λ S first moment of mass about the node, J = Λ J₀ Λᵀ inertia about
// the node (both spatial), a' = a − g acceleration less gravity. Force and moment about the node are stacked
// in a Vec6.
namespace gxrod {

// Constants in the global axes of t = 0.
struct RigidInertia {
    double mass = 0.0;
    Vec3 first_moment = Vec3::Zero();  // S, mass × (centre of mass − node)
    Mat3 inertia = Mat3::Zero();       // J₀, about the node
};

// The contribution of a small body to the momentum of the whole.
struct Momentum {
    Vec3 linear = Vec3::Zero();
    Vec3 angular = Vec3::Zero();  // about the origin
};

// Computes the constants of a body given about its centre of mass: `axes` are its axes at t = 0,
// `centre_of_mass` runs from the node in those axes, `inertia` is about the centre of mass in those axes.
RigidInertia compute_rigid_inertia(double mass,
                                   const Mat3& inertia,
                                   const Vec3& centre_of_mass,
                                   const Quat& axes);

// Computes the inertial force and moment: m a' + α × s + ω × (ω × s) and J α + ω × J ω + s × a' (Rubin 2007,
// (5.1), with an offset).
Vec6 compute_inertial_force(const RigidInertia& body, const NodeMotion& motion, const Vec3& gravity);

// Computes the derivative of compute_inertial_force by (δr, δφ); without offset, the tangent (5.6) of Rubin
// (2007).
Mat6 compute_inertial_tangent(const RigidInertia& body,
                              const NodeMotion& motion,
                              const NodeLinearization& linearization,
                              const Vec3& gravity);

double compute_kinetic_energy(const RigidInertia& body, const NodeMotion& motion);
Momentum compute_momentum(const RigidInertia& body, const NodeMotion& motion);
// Computes −g · (first moment of mass about the origin).
double compute_gravity_potential(const RigidInertia& body, const NodeMotion& motion, const Vec3& gravity);

}  // namespace gxrod
