#pragma once

#include "rotation/half_rotation.hpp"
#include "state/spring_line.hpp"

namespace gxrod {

// How the ends of a bushing lie to each other at a motion (docs/theory/springs.md).
struct BushingMotion {
    Mat3 axes = Mat3::Identity();     // half way between those that A and B carry: columns are x, y, z
    HalfRotation<double> turn;        // of B against A, in the axes
    PointDistance distance;           // spatial
    Vec3 turn_rate = Vec3::Zero();    // ω of B less that of A, spatial
    Vec3 middle_spin = Vec3::Zero();  // of the axes, spatial
    Vec6 strain = Vec6::Zero();       // displacement and rotation vector of B against A, in the axes
    Vec6 strain_rate = Vec6::Zero();
};

// `a`, `b`: of the nodes that carry A and B; nullptr for the ground.
BushingMotion compute_bushing_motion(const Bushing& bushing, const NodeMotion* a, const NodeMotion* b);

// X v, which takes what the spins of A and B differ by, in the axes, to the rate of the rotation vector.
Vec3 take_to_rotation_vector(const HalfRotation<double>& turn, const Vec3& v);

// Force and moment of the bushing, in its axes: what work their strains' rates do.
Vec6 compute_bushing_force(const Bushing& bushing, const BushingMotion& motion);

}  // namespace gxrod
