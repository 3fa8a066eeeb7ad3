#pragma once

#include <vector>

#include "model/model.hpp"
#include "state/motion.hpp"

namespace gxrod {

// The line of a spring from its point A to its point B at a motion (docs/theory/springs.md).
struct SpringLine {
    Vec3 d = Vec3::Zero();          // from A to B
    Vec3 rate = Vec3::Zero();       // of d
    double length = 0.0;            // ℓ
    double length_rate = 0.0;       // 0 at length 0, which has no direction
    Vec3 direction = Vec3::Zero();  // e, from A to B; not a number at length 0
};

// `a`, `b`: of the nodes that carry A and B; nullptr for the ground.
SpringLine compute_spring_line(const Spring& spring, const NodeMotion* a, const NodeMotion* b);
// Of motions of all nodes.
SpringLine compute_spring_line(const Spring& spring, const std::vector<NodeMotion>& nodes);

// N = k (ℓ − ℓ₀) + c ℓ̇, tension positive.
double compute_axial_force(const Spring& spring, const SpringLine& line);

}  // namespace gxrod
