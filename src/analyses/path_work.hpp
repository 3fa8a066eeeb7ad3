#pragma once

#include <functional>
#include <optional>

#include "analyses/static_work.hpp"

namespace gxrod {

// An equilibrium on the way from one accepted equilibrium to the next. Forces and moments per node, and then
// those on the coordinates of joints, are those that do work; `turned` is how nodes are turned since the
// first of both, for turns of more than a half.
struct PathPoint {
    double load_factor = 0.0;
    double strain_energy = 0.0;  // and what laws of sections have dissipated since the first of both
    std::vector<Vec6> forces;
    std::vector<Vec3> turned;
    std::vector<Vec6> coordinates;  // of joints
    State state;                    // its trial motions; to continue from: committed there
    double dissipated = 0.0;        // by laws of sections, since the first of both
    int iterations = 0;             // that it took to find it from the one before
};

// Finds the equilibrium at a load factor from another one, if it can.
using FindEquilibrium = std::function<std::optional<PathPoint>(const PathPoint& from, double load_factor)>;

// How a load step is looked into.
struct PathSearch {
    FindEquilibrium find;
    double tolerable;  // how far strain energy and work of a piece may part
    int halvings;
};

// A step that takes as many iterations may jump, whatever the energies at its ends say.
inline constexpr int many_iterations = 7;

// The work from one equilibrium to another where the trapezoidal rule over all of the step parts too far from
// the strain energy, or the step took many iterations: the step is halved, and again the half that is not
// right, as often as `search` admits. What a jump loses stays, since no equilibria in between make it less.
// Where a jump passes several equilibria, the energies at its ends can agree by accident.
StepWork integrate_path(const PathPoint& from, const PathPoint& to, const PathSearch& search);

}  // namespace gxrod
