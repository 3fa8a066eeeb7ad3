#pragma once

#include "rotation/types.hpp"

namespace gxrod {

// Values of a joint at a step that histories record. A exerts the forces and moments on B, moments about the
// joint's point.
struct JointValues {
    double turn = 0.0;  // turn of B against A, any number of turns; 0 if the joint has none
    double turn_rate = 0.0;
    double slide = 0.0;  // likewise
    double slide_rate = 0.0;
    Vec3 force = Vec3::Zero();  // global
    Vec3 moment = Vec3::Zero();
    Vec3 force_in_joint = Vec3::Zero();  // in the axes of A's side, the joint's own first
    Vec3 moment_in_joint = Vec3::Zero();
    double drive_turn = 0.0;   // moment that drives the turn: from a motor, or given
    double drive_slide = 0.0;  // force that drives the slide, likewise
    double friction = 0.0;     // moment or force of it
    double gap = 0.0;          // how far the joint's equations are from being satisfied, a length
    double play = 0.0;  // distance of the points of a joint with clearance; ratio × first + second of a gear
    double curve_place = 0.0;   // arc length of a cam's curve from its first point to the roller
    double curve_gap = 0.0;     // how far the roller is from it
    double normal_force = 0.0;  // of the curve on the roller; positive if it pushes
    bool holds = true;          // whether it acts in the stage, and is not broken
};

}  // namespace gxrod
