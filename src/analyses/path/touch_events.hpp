#pragma once

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "analyses/path/path_search.hpp"

namespace gxrod {

// Two things that touch: a rod, or body number − count of rods, and another one or obstacle j as −1 − j.
using TouchingThings = std::array<int, 2>;

// A place on a path where things begin to touch each other, or leave each other.
struct TouchEvent {
    bool begins = true;
    std::vector<TouchingThings> things;  // all for which it is the same place
};

// Finds what begins or ceases to touch within a step from the last accepted equilibrium.
class TouchSearch {
  public:
    // The context and the direction must outlive it. The trial motions are those of the end of the step.
    TouchSearch(PathContext& work, const PathVector& direction, const PathTrial& end);

    bool found() const { return !changes_.empty(); }
    // Returns the changes of the whole step, those of the first kind.
    TouchEvent list() const;
    // Locates the first of them, as an equilibrium that the trial motions and `trial` hold; nullopt if it
    // cannot be found.
    std::optional<TouchEvent> locate(PathTrial& trial);

  private:
    // The gap of two things less the gap below which they touch, at both ends of the step.
    struct Change {
        TouchingThings things;
        double before = 0.0, after = 0.0;
    };
    double measure(const TouchingThings& things, const State& state, double load_factor) const;

    PathContext& work_;
    const PathVector& direction_;
    PathTrial end_;
    std::vector<Change> changes_;
};

// Describes the things of an event: "rod beam and obstacle floor".
std::string name_touching(const Model& model, const std::vector<TouchingThings>& things);

}  // namespace gxrod
