#pragma once

#include <algorithm>
#include <span>
#include <type_traits>
#include <vector>

#include "rotation/types.hpp"

namespace gxrod {

// The largest force and moment that one element or load exerts on a node; for bodies, also their inertia
// forces. A residual is compared with them.
struct ForceScales {
    double force_scale = 0.0;
    double moment_scale = 0.0;

    void raise(double force, double moment) {
        force_scale = std::max(force_scale, force);
        moment_scale = std::max(moment_scale, moment);
    }
    void raise(const ForceScales& other) { raise(other.force_scale, other.moment_scale); }
    // Raises the scales to a force on one node, or a stack of them.
    template <class Vector>
        requires(!std::is_same_v<Vector, ForceScales>)
    void raise(const Vector& force) {
        for (int i = 0; i < force.size(); i += 6) {
            raise(force.template segment<3>(i).template lpNorm<Eigen::Infinity>(),
                  force.template segment<3>(i + 3).template lpNorm<Eigen::Infinity>());
        }
    }
};

// The scales of the groups (ScaleGroups) of one part of the work.
struct PartScales {
    std::span<ForceScales> scales;
    int first_group = 0;

    ForceScales& of(int group) const { return scales[static_cast<std::size_t>(group - first_group)]; }
};

// The imbalance at every node: internal + damping + inertial − external.
struct Residual : ForceScales {
    std::vector<Vec6> nodal;          // at held components, the force that the support exerts
    std::vector<double> rows;         // equations of joints, one joint after the other (JointAssembly)
    std::vector<ForceScales> groups;  // scales of each group of the model; empty if no scales are asked for

    void raise_group(int group, const Vec6& force) {
        if (!groups.empty()) groups[static_cast<std::size_t>(group)].raise(force);
    }
};

}  // namespace gxrod
