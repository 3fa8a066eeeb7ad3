#pragma once

#include "rotation/types.hpp"

// The treaty between elements and integrators: the only two structs that pass between them.
namespace gxrod {

// The motion of a node at the time of an equilibrium, as integrators give it to elements. All spatial.
struct NodeMotion {
    Vec3 r = Vec3::Zero();           // position
    Quat Lambda = Quat::Identity();  // rotation since the reference configuration (identity at the start)
    Vec3 theta = Vec3::Zero();       // rotation vector since the last accepted step
    Vec3 v = Vec3::Zero();
    Vec3 a = Vec3::Zero();
    Vec3 omega = Vec3::Zero();
    Vec3 alpha = Vec3::Zero();
};

// Derivatives of that motion by the node's Newton unknowns, the displacement δr and the spatial spin δφ:
//   δv = rate δr, δa = acceleration δr, δω = d_omega δφ, δα = d_alpha δφ.
// placement (1 or 0) multiplies every term of a tangent that comes from δr, δφ directly.
struct NodeLinearization {
    double placement = 0.0;
    double rate = 0.0;
    double acceleration = 0.0;
    Mat3 d_omega = Mat3::Zero();
    Mat3 d_alpha = Mat3::Zero();
};

}  // namespace gxrod
