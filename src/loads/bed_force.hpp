#pragma once

#include "environment/ground.hpp"
#include "state/bed_contact.hpp"
#include "state/motion.hpp"

namespace gxrod {

// A piece of a rod, or a body's node, that can touch the ground.
struct BedPoint {
    double radius = 0.0;  // distance from the line to the surface that touches
    double area = 0.0;    // diameter × length of the piece
    Vec3 axis =
        Vec3::Zero();  // the rod's tangent now, of length 1; zero for a body, whose friction is lateral
};

// The force on the node, spatial; `before` is the contact at the last accepted step.
struct BedForce {
    Vec3 force = Vec3::Zero();
    double pressure = 0.0;  // its part along the normal
    BedContact after{};     // the contact that commit stores
};
BedForce compute_bed_force(const Seabed& seabed,
                           const BedPoint& point,
                           const NodeMotion& motion,
                           const BedContact& before);

struct BedForceDerivative {
    Mat3 by_r = Mat3::Zero();
    Mat3 by_phi = Mat3::Zero();  // through the axis
    Mat3 by_v = Mat3::Zero();
};
BedForceDerivative compute_bed_force_derivative(const Seabed& seabed,
                                                const BedPoint& point,
                                                const NodeMotion& motion,
                                                const BedContact& before);

}  // namespace gxrod
