#pragma once

#include <optional>

#include "analyses/path/path_curve.hpp"
#include "analyses/path/path_search.hpp"

namespace gxrod {

// Equilibria that a path must hit exactly: at requested load factors and displacements, and at the bounds
// that end it.
class PathTargets {
  public:
    // The system must outlive this. Throws std::invalid_argument if a support holds a component.
    PathTargets(const System& system, const PathSettings& settings);

    // A step from the last accepted equilibrium along the path's direction there to the trial motions; all
    // increments but the first are orthogonal to `row`.
    struct Step {
        const PathVector& direction;
        const PathVector& row;
        // Whether a target may be skipped if it only seems to be passed, because a value turns back within
        // the step.
        bool is_short;
    };
    // If the step passes targets, moves the trial motions to the first of them. Returns false if it was
    // passed but not found.
    bool hit(PathContext& work, const Step& step, PathTrial& trial) const;
    // Whether the path ends at these motions.
    bool is_end(const std::vector<NodeMotion>& motions, double load_factor) const;
    // Returns the derivative of the displacement or rotation that controls a path by the movement.
    PathVector row_of(const PathControl& control) const;
    double value_of(const PathControl& control, const std::vector<NodeMotion>& motions) const;

  private:
    // Returns the derivative of the target's value by the movement.
    PathVector row_of(const PathTarget& target) const;
    PathVector row_of(int node, int component) const;
    struct Hit {
        const PathTarget* target;
        double value;             // the target's value less the value at the last accepted equilibrium
        double part;              // part of the step
        bool is_between = false;  // whether the value lies between the values at both ends
    };
    double value_of(const PathTarget& target, const NodeMotion* motion, double load_factor) const;
    std::optional<Hit> find_first(const PathContext& work, const PathCurve& curve, double load_factor) const;

    const System* system_;
    std::optional<double> least_load_, greatest_load_;
    std::vector<PathTarget> targets_;
    std::optional<PathControl> control_;
};

}  // namespace gxrod
