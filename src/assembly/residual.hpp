#pragma once

#include <algorithm>
#include <vector>

#include "rotation/types.hpp"

namespace gxrod {

// What is out of balance at every node: internal + damping + inertial − external.
struct Residual {
    std::vector<Vec6> nodal;  // held components hold the force that the support exerts
    // The largest force and moment that one element or load puts on a node, and of bodies the part due to
    // accelerations; a residual is small against these.
    double force_scale = 0.0;
    double moment_scale = 0.0;
};

// Raises the scales to what a force on one node, or a stack of them, holds.
template <class Vector>
void raise_scales(const Vector& force, Residual& residual) {
    for (int i = 0; i < force.size(); i += 6) {
        residual.force_scale =
            std::max(residual.force_scale, force.template segment<3>(i).template lpNorm<Eigen::Infinity>());
        residual.moment_scale = std::max(residual.moment_scale,
                                         force.template segment<3>(i + 3).template lpNorm<Eigen::Infinity>());
    }
}

}  // namespace gxrod
