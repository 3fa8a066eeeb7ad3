#pragma once

#include <optional>

#include "analyses/path/path_curve.hpp"
#include "analyses/path/path_search.hpp"

namespace gxrod {

// Equilibria that a path must hit exactly: at asked load factors and displacements, and where its bounds end
// it.
class PathTargets {
  public:
    // The system must outlive it. Throws std::invalid_argument if a support holds a component.
    PathTargets(const System& system, const PathSettings& settings);

    // How a step was made: from the last accepted equilibrium along the path's direction there to the trial
    // motions, all increments but the first orthogonal to `row`.
    struct Step {
        const PathVector& direction;
        const PathVector& row;
        // Whether what may only seem to be passed, where a value turns back within the step, can be left.
        bool is_short;
    };
    // If the step passes targets, the first of them: then the trial motions hold that. False if it was passed
    // but not found.
    bool hit(PathContext& work, const Step& step, PathTrial& trial) const;
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
        double value;             // what is to be reached, less what it is at the last accepted equilibrium
        double part;              // of the step
        bool is_between = false;  // whether it lies between the values at both ends
    };
    double value_of(const PathTarget& target, const NodeMotion* motion, double load_factor) const;
    std::optional<Hit> find_first(const PathContext& work, const PathCurve& curve, double load_factor) const;

    const System* system_;
    std::optional<double> least_load_, greatest_load_;
    std::vector<PathTarget> targets_;
    std::optional<PathControl> control_;
};

}  // namespace gxrod
