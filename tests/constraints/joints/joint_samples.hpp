#pragma once

#include <string>
#include <vector>

#include "constraints/joints/joint_rows.hpp"
#include "tools/random_values.hpp"

// Joints of every kind at random places, with and without motors and grounds, and motions of their two sides.
namespace gxrod::tools {

struct JointSample {
    std::string name;
    Joint joint;
    NodeMotion previous_a, previous_b;  // the last accepted step
    NodeMotion a, b;                    // anywhere, not closed; the ground at rest
    double turn_before = 0.0;
    JointMotors motors;

    JointMotions motions() const { return {a, b}; }
};

// All of them.
const std::vector<JointSample>& joint_samples();

// A cam about as large as this.
JointCam make_cam(double size);

// A joint without motors.
Joint make_joint(JointKind kind, RandomValues& random);

// Where a closed joint's free coordinates are; which of them count depends on the kind.
struct FreeCoordinates {
    double turn = 0.0;
    double second_turn = 0.0;        // of a universal joint about B's axis
    double slide = 0.0;              // not of a screw, whose turn says it
    Vec3 across = Vec3::Zero();      // of a plane: slides along the second and third axis of A
    Quat ball = Quat::Identity();    // of a ball, a distance joint or a cam: B against A
    Vec3 direction = Vec3::UnitX();  // of a distance joint: from A to B
};
FreeCoordinates make_free_coordinates(RandomValues& random);

// Position and rotation of B's node that close a joint whose A is there.
NodeMotion close(const Joint& joint, const NodeMotion& a, const FreeCoordinates& free);

// The motion of everything by x ↦ R x + d, with the rotation R.
NodeMotion move_rigidly(const NodeMotion& motion, const Quat& R, const Vec3& d);

}  // namespace gxrod::tools
