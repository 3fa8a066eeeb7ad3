#pragma once

#include <array>

#include "elements/spring_line.hpp"
#include "rotation/swing.hpp"
#include "state/values/bushing_values.hpp"

namespace gxrod {

// The measure of the turn of B against A that a bushing uses.
struct BushingTurn {
    enum class Kind {
        spin,   // the difference of the spins alone: no stiffness resists rotations
        swing,  // the swing of one axis, about which no stiffness resists rotations, and the rate of twist
        vector  // the rotation vector
    };
    Kind kind = Kind::spin;
    int axis = 0;  // axis of the swing
};
BushingTurn find_bushing_turn(const Bushing& bushing);

// Returns whether end 0 (A) or 1 (B) carries the axes.
bool carries_axes(const Bushing& bushing, std::size_t end);

// The position and rates of B relative to A for a bushing whose axes one end, or the ground, carries
// (docs/theory/springs.md). All are spatial except strain and rate.
struct CarriedBushingMotion {
    Mat3 axes = Mat3::Identity();  // columns are x, y, z
    Vec3 axes_spin = Vec3::Zero();
    PointDistance distance;
    Vec3 turn_rate = Vec3::Zero();  // ω of B − ω of A
    PairedVector turn;              // e, of B against A; it follows spins of A and B
    PairedVector turn_change;       // ė; it follows δφ of A and B at fixed spins
    PairedVector twist;             // the direction whose product with turn_rate is the rate of the twist
    Vec6 strain = Vec6::Zero();     // in the axes: displacement and e
    Vec6 rate = Vec6::Zero();       // in the axes
};

// Computes it from the motions `a`, `b` of the nodes that carry A and B; nullptr for the ground.
CarriedBushingMotion compute_carried_motion(const Bushing& bushing, const NodeMotion* a, const NodeMotion* b);

// Computes the spatial moments on A and on B from the moments `own`, in the axes, that do work on the rates.
std::array<Vec3, 2> distribute_moment(const Bushing& bushing,
                                      const CarriedBushingMotion& motion,
                                      const Vec3& own);

// Computes the derivatives of these moments by the spins of A and B, through e and the twist, at fixed
// moments in the axes: [i][j] is the moment on i by the spin of j.
std::array<std::array<Mat3, 2>, 2> differentiate_moments(const Bushing& bushing,
                                                         const CarriedBushingMotion& motion,
                                                         const NodeMotion* a,
                                                         const NodeMotion* b,
                                                         const Vec3& own);

// Computes what histories record of a bushing, whatever carries its axes, likewise.
BushingValues measure(const Bushing& bushing, const NodeMotion* a, const NodeMotion* b);

}  // namespace gxrod
