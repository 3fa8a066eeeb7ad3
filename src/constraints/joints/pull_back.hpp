#pragma once

#include "constraints/joints/jet.hpp"
#include "state/motion.hpp"

namespace gxrod {

// Applies (J4), transposed: the derivative by a node's δφ of a vector u that it carries, and of u̇ and ü,
// each multiplied by its g. All are spatial.
inline Vec3 pull_back_carried(const VectorJet& u,
                              const VectorJet& g,
                              const NodeMotion& motion,
                              const NodeLinearization& linearization) {
    const Vec3 of_rate = g.rate + g.acceleration.cross(motion.omega);
    const Vec3 of_value = g.value + g.acceleration.cross(motion.alpha) + of_rate.cross(motion.omega);
    const Vec3 by_omega = u.rate.cross(g.acceleration) + u.value.cross(of_rate);
    const Vec3 by_alpha = u.value.cross(g.acceleration);
    return linearization.placement * u.value.cross(of_value) + linearization.d_omega.transpose() * by_omega +
           linearization.d_alpha.transpose() * by_alpha;
}

// Computes the same derivative by δr, for the node's position and its rates.
inline Vec3 pull_back_moved(const VectorJet& g, const NodeLinearization& linearization) {
    return linearization.placement * g.value + linearization.rate * g.rate +
           linearization.acceleration * g.acceleration;
}

}  // namespace gxrod
