#pragma once

#include <string>
#include <utility>
#include <vector>

#include "state/motion.hpp"

// Motions of single nodes, to differentiate along.
namespace gxrod::tools {

// A node moved along the direction (δr, δφ) by the factor `amount`, in place only.
NodeMotion move(const NodeMotion& previous, const NodeMotion& motion, const Vec6& direction, double amount);

// A node at the given amount along a linearized motion: placement, rates and accelerations follow (δr, δφ).
NodeMotion follow(const NodeMotion& previous,
                  const NodeMotion& motion,
                  const NodeLinearization& linearization,
                  const Vec6& direction,
                  double amount);

// Each member of a linearization alone, and all together.
std::vector<std::pair<std::string, NodeLinearization>> make_linearizations(unsigned seed = 11);

// A node's smooth motion through `start` at t = 0: r and the rotation vector are cubic in t.
struct SmoothMotion {
    NodeMotion start;
    Vec3 r_jerk, theta_dot, theta_ddot, theta_jerk;

    NodeMotion at(double t) const;
};

}  // namespace gxrod::tools
