#pragma once

#include <array>

namespace gxrod {

// The variables of a joint that evolve in time.
struct JointState {
    std::array<double, 6> multipliers{};       // per equation: forces and moments that A exerts on B
    double turn = 0.0;                         // turn of B against A about the axis, whole turns included
    double slide = 0.0;                        // slide; for a sleeve along its rod, from its place at t = 0
    double turn_slip = 0.0, slide_slip = 0.0;  // values of turn and slide where their friction is zero
};

}  // namespace gxrod
