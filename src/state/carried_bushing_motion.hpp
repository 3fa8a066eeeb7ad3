#pragma once

#include <array>

#include "rotation/swing.hpp"
#include "state/spring_line.hpp"

namespace gxrod {

// The turn of B against A as a bushing sees it.
struct BushingTurn {
    enum class Kind {
        spin,   // the difference of the spins alone: no stiffness resists rotations
        swing,  // the swing of one axis, about which rotations are free of stiffness, and the rate of the
                // twist
        vector  // the rotation vector
    };
    Kind kind = Kind::spin;
    int axis = 0;  // of the swing
};
BushingTurn find_bushing_turn(const Bushing& bushing);

// Whether A (0) or B (1) carries the axes.
bool carries_axes(const Bushing& bushing, std::size_t end);

// How the ends of a bushing whose axes one end carries, or the ground, lie to each other at a motion
// (docs/theory/springs.md). All spatial but strain and rate.
struct CarriedBushingMotion {
    Mat3 axes = Mat3::Identity();  // columns are x, y, z
    Vec3 axes_spin = Vec3::Zero();
    PointDistance distance;
    Vec3 turn_rate = Vec3::Zero();  // ω of B less that of A
    PairedVector turn;              // e, of B against A; it follows spins of A and B
    PairedVector turn_change;       // ė; it follows δφ of A and B at fixed spins
    PairedVector twist;             // the direction whose product with turn_rate is the rate of the twist
    Vec6 strain = Vec6::Zero();     // in the axes: displacement and e
    Vec6 rate = Vec6::Zero();       // in the axes
};

// `a`, `b`: of the nodes that carry A and B; nullptr for the ground.
CarriedBushingMotion compute_carried_motion(const Bushing& bushing, const NodeMotion* a, const NodeMotion* b);

// The moments on A and on B, spatial, of those in the axes that do work on the rates.
std::array<Vec3, 2> distribute_moment(const Bushing& bushing,
                                      const CarriedBushingMotion& motion,
                                      const Vec3& own);

// The derivatives of these moments by spins of A and B at fixed moments in the axes, as far as e and the
// twist do: [i][j] on i by j.
std::array<std::array<Mat3, 2>, 2> differentiate_moments(const Bushing& bushing,
                                                         const CarriedBushingMotion& motion,
                                                         const NodeMotion* a,
                                                         const NodeMotion* b,
                                                         const Vec3& own);

}  // namespace gxrod
