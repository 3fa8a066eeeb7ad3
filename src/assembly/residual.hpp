#pragma once

#include <algorithm>
#include <span>
#include <type_traits>
#include <vector>

#include "rotation/types.hpp"

namespace gxrod {

// The largest force and moment that one element or load puts on a node, and of bodies the part due to
// accelerations; a residual is small against these.
struct ForceScales {
    double force_scale = 0.0;
    double moment_scale = 0.0;

    void raise(double force, double moment) {
        force_scale = std::max(force_scale, force);
        moment_scale = std::max(moment_scale, moment);
    }
    void raise(const ForceScales& other) { raise(other.force_scale, other.moment_scale); }
    // To what a force on one node, or a stack of them, holds.
    template <class Vector>
        requires(!std::is_same_v<Vector, ForceScales>)
    void raise(const Vector& force) {
        for (int i = 0; i < force.size(); i += 6) {
            raise(force.template segment<3>(i).template lpNorm<Eigen::Infinity>(),
                  force.template segment<3>(i + 3).template lpNorm<Eigen::Infinity>());
        }
    }
};

// Those of the groups (ScaleGroups) that one part of the work belongs to.
struct PartScales {
    std::span<ForceScales> scales;
    int first_group = 0;

    ForceScales& of(int group) const { return scales[static_cast<std::size_t>(group - first_group)]; }
};

// What is out of balance at every node: internal + damping + inertial − external.
struct Residual : ForceScales {
    std::vector<Vec6> nodal;          // held components hold the force that the support exerts
    std::vector<double> rows;         // equations of joints, one joint after the other (JointAssembly)
    std::vector<ForceScales> groups;  // of each group of the model; empty where no scales are asked for

    void raise_group(int group, const Vec6& force) {
        if (!groups.empty()) groups[static_cast<std::size_t>(group)].raise(force);
    }
};

}  // namespace gxrod
