#pragma once

#include <array>
#include <memory>
#include <optional>
#include <string>

#include "model/anchor.hpp"
#include "model/time/time_function.hpp"
#include "numerics/plane_curve.hpp"
#include "rotation/types.hpp"

namespace gxrod {

// The kinds of joints, by the motions of B against A that they leave free.
enum class JointKind {
    ball,       // all turns
    hinge,      // a turn about the axis
    cylinder,   // a turn about the axis and a slide along it
    slider,     // a slide along the axis
    universal,  // turns about the axis, which A carries, and about a second one at right angles to it, which
                // B carries
    screw,      // a turn about the axis coupled to a slide along it
    plane,      // slides across the axis and the turn about it
    weld,       // nothing
    distance,   // all but a change of the distance of two points
    free,       // everything
    generic,    // what Joint::held does not name
    cam,        // all but the distance of B's point from a curve that A carries, in the curve's plane
    sleeve      // a point, the slide along a rod and all turns: a Sleeve, not a Joint
};

// A joint's side: its point, and axes at t = 0, global; columns are the joint's axis and two across it. Both
// sides have the same axes, except B of a universal joint, whose first column is the axis that B carries and
// whose second is the axis that A carries.
struct JointSide {
    Anchor anchor;
    Mat3 axes = Mat3::Identity();
};

// Friction of a free coordinate: within ± its strength (a moment for a turn, a force for a slide) it sticks,
// elastically up to `stick` (rad or length). The strength is `force` plus `lever` times the force that the
// joint holds across the coordinate or at its point.
struct Friction {
    double force = 0.0;
    double stick = 0.0;
    double lever = 0.0;  // for a turn a length, coefficient × radius; for a slide the coefficient

    bool acts() const { return force > 0.0 || lever > 0.0; }
};

// Bounds of a free coordinate, beyond which a spring and a damper act; without stiffness it stops there. At
// the depth g they push with stiffness gⁿ (1 + hysteresis ġ) + damping ġ, and never pull.
struct CoordinateLimits {
    std::optional<double> lower, upper;
    double stiffness = 0.0;
    double damping = 0.0;
    double exponent = 1.0;    // n
    double hysteresis = 0.0;  // time/length

    bool act() const { return lower || upper; }
    bool are_rigid() const { return act() && stiffness == 0.0; }
};

// The actions on a coordinate that a joint leaves free. A turn is the right-hand turn of B against A about
// the axis, in rad, over any number of turns; a slide is of B against A along the axis. Both are 0 at t = 0.
// A universal joint's turn is about A's axis.
struct JointCoordinate {
    std::optional<TimeFunction> motion;  // a motor: the coordinate as a function of time
    TimeFunction drive;                  // additional moment or force that A exerts on B
    double stiffness = 0.0;
    double damping = 0.0;
    TimeFunction rest;  // value at which the spring is free of force
    Friction friction;
    CoordinateLimits limits;
};

// Play between the points of a joint, a pin in a hole or a ball in a socket: free within a distance of each
// other, across the axis if the joint has one, and in contact beyond it.
struct JointClearance {
    CoordinateLimits contact;  // its upper bound is the distance
    double friction = 0.0;     // Coulomb's coefficient, on the surface of the pin or ball
    double radius = 0.0;       // radius of the pin or ball
    double slip_speed = 0.0;   // at which friction is 1/√2 of its limit; positive with friction

    bool dissipates() const { return friction > 0.0 || contact.damping > 0.0 || contact.hysteresis > 0.0; }
};

// The curve of a cam, in the plane of A's second and third axis, its origin at A's point, and the radius of
// the roller around B's point that touches it; 0 of a knife edge.
struct JointCam {
    std::shared_ptr<const PlaneCurve> curve;
    double roller = 0.0;
    double side = 1.0;   // of the roller: 1 on the right of the curve, −1 on its left
    bool lifts = false;  // whether the roller may leave the curve; otherwise a groove holds it
};

// The largest force and moment that a joint holds, and how long it holds. It breaks at the end of a step in
// which it holds more, or at this time, and then holds nothing.
struct JointStrength {
    std::optional<double> force;      // of the rows that are lengths
    std::optional<double> moment;     // of the others
    std::optional<double> time = {};  // t of the stage at hand, at which a step ends

    bool is_limited() const { return force || moment || time; }
};

// A joint between two points A and B of rods, bodies or the ground.
struct Joint {
    std::string name;
    JointKind kind = JointKind::ball;
    JointSide a, b;  // at most one on the ground
    JointCoordinate turn, slide;
    double lead = 0.0;        // for a screw: slide per turn
    double length = 0.0;      // for a distance joint
    bool pulls_only = false;  // for a distance joint: holds where it would be longer than that
    // For a generic joint: whether it holds the displacements along A's axes, and the turns about them. Of
    // turns that are not held two are those of a universal joint.
    std::array<bool, 6> held{};
    std::optional<JointClearance> clearance = {};  // of a ball, a hinge or a cylinder
    std::optional<JointCam> cam = {};              // of a cam
    JointStrength strength;
    bool acts = true;  // in the stage at hand; otherwise it holds nothing

    // Whether it has equations that hold on one side only.
    bool has_stops() const {
        return pulls_only || (cam && cam->lifts) || turn.limits.are_rigid() || slide.limits.are_rigid();
    }
    bool has_ground() const { return a.anchor.is_ground() || b.anchor.is_ground(); }
    // Returns B's anchor, or A's if B is on the ground.
    const Anchor& moving_anchor() const { return b.anchor.is_ground() ? a.anchor : b.anchor; }
    // Whether the kind leaves one turn about an axis, or one slide along it, free.
    bool has_turn() const;
    bool has_slide() const;
};

// A point B that slides along a rod, A, whose line is the smooth one through its nodes. Forces on the slide
// act along the line; the slide is the arc length at t = 0, from the initial place.
struct Sleeve {
    std::string name;
    int rod = 0;         // in Model::rods, one line
    Anchor point;        // B
    double place = 0.0;  // arc length at t = 0
    JointCoordinate slide = {};
    bool holds_turn = false;  // whether B does not turn against the rod's section where it is
};

}  // namespace gxrod
