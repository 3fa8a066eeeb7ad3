#pragma once

#include <optional>

#include "analyses/path/path_search.hpp"

namespace gxrod {

// Equilibria that a path must hit exactly: at asked load factors and displacements, and where its bounds end
// it.
class PathTargets {
  public:
    // The system must outlive it. Throws std::invalid_argument if a support holds a component.
    PathTargets(const System& system, const PathSettings& settings);

    // If the step from the last accepted equilibrium to the trial motions passes targets, the first of them:
    // then the trial motions hold that. False if it was passed but not found.
    bool hit(PathContext& work, PathTrial& trial) const;
    // Whether the path ends there.
    bool is_end(const std::vector<NodeMotion>& motions, double load_factor) const;
    // How the displacement or rotation that controls a path follows the movement.
    PathVector row_of(const PathControl& control) const;
    double value_of(const PathControl& control, const std::vector<NodeMotion>& motions) const;

  private:
    // How PathTarget's value follows the movement.
    PathVector row_of(const PathTarget& target) const;
    PathVector row_of(int node, int component) const;
    struct Hit {
        const PathTarget* target;
        double part;  // of the step
    };
    double value_of(const PathTarget& target, const NodeMotion* motion, double load_factor) const;
    std::optional<Hit> find_first(const PathContext& work, double load_factor) const;

    const System* system_;
    std::optional<double> least_load_, greatest_load_;
    std::vector<PathTarget> targets_;
    std::optional<PathControl> control_;
};

}  // namespace gxrod
