#pragma once

#include <array>
#include <vector>

#include "model/model.hpp"
#include "state/motion.hpp"
#include "state/values/spring_values.hpp"

namespace gxrod {

// The vector from A to B, which nodes or the ground carry.
struct PointDistance {
    Vec3 d = Vec3::Zero();
    Vec3 rate = Vec3::Zero();  // rate of d
};

// Computes it from the motions `a`, `b` of the nodes that carry A and B; nullptr for the ground.
PointDistance compute_distance(const std::array<Anchor, 2>& ends, const NodeMotion* a, const NodeMotion* b);

// The line of a spring from its point A to its point B at a motion (docs/theory/springs.md).
struct SpringLine : PointDistance {
    double length = 0.0;            // ℓ
    double length_rate = 0.0;       // 0 at length 0, which has no direction
    Vec3 direction = Vec3::Zero();  // e, from A to B; not a number at length 0
};

// Computes the line from the motions of the nodes that carry A and B, likewise.
SpringLine compute_spring_line(const Spring& spring, const NodeMotion* a, const NodeMotion* b);
// Computes it from the motions of all nodes.
SpringLine compute_spring_line(const Spring& spring, const std::vector<NodeMotion>& nodes);

// Computes the tension in addition while the length changes: c ℓ̇ + f(ℓ, ℓ̇) − f(ℓ, 0).
double compute_damper_tension(const Spring& spring, double length, double length_rate);
// Computes N, the sum of both.
double compute_axial_force(const Spring& spring, const SpringLine& line);

// Computes what histories record, from the motions of the nodes that carry A and B; nullptr for the ground.
SpringValues measure(const Spring& spring, const NodeMotion* a, const NodeMotion* b);

}  // namespace gxrod
