#pragma once

#include "elements/spring_line.hpp"
#include "rotation/half_rotation.hpp"

namespace gxrod {

// The position and rates of a bushing's end B relative to its end A (docs/theory/springs.md).
struct BushingMotion {
    Mat3 axes = Mat3::Identity();     // half way between the axes that A and B carry; columns: x, y, z
    HalfRotation<double> turn;        // turn of B against A, in the axes
    PointDistance distance;           // spatial
    Vec3 turn_rate = Vec3::Zero();    // ω of B − ω of A, spatial
    Vec3 middle_spin = Vec3::Zero();  // spin of the axes, spatial
    Vec6 strain = Vec6::Zero();       // displacement and rotation vector of B against A, in the axes
    Vec6 rate = Vec6::Zero();
};

// Computes it from the motions `a`, `b` of the nodes that carry A and B; nullptr for the ground.
BushingMotion compute_bushing_motion(const Bushing& bushing, const NodeMotion* a, const NodeMotion* b);

// Computes X v: X takes the difference of the spins of B and A, in the axes, to the rate of the rotation
// vector.
Vec3 take_to_rotation_vector(const HalfRotation<double>& turn, const Vec3& v);

// Computes the force and moment of the bushing in its axes, conjugate to the rates of its strains.
Vec6 compute_bushing_force(const Bushing& bushing, const BushingMotion& motion);

}  // namespace gxrod
