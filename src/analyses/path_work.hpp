#pragma once

#include <functional>
#include <optional>

#include "analyses/static_work.hpp"

namespace gxrod {

// An equilibrium on the way from one accepted equilibrium to the next. `forces` are the forces and moments
// per node, then the forces on the coordinates of joints, as far as they do work; `turned` is the rotation of
// the nodes since the first of the two equilibria, for turns of more than a half.
struct PathPoint {
    double load_factor = 0.0;
    double strain_energy = 0.0;  // plus the dissipation of section laws since the first of the two equilibria
    std::vector<Vec6> forces;
    std::vector<Vec3> turned;
    std::vector<Vec6> coordinates;  // coordinates of joints
    State state;                    // trial motions; to continue from here, committed here
    double dissipated = 0.0;        // dissipation of section laws since the first of the two equilibria
    int iterations = 0;             // iterations from the point before
};

// Finds the equilibrium at a load factor from another one, if it can.
using FindEquilibrium = std::function<std::optional<PathPoint>(const PathPoint& from, double load_factor)>;

// Options of a search for jumps in a load step.
struct PathSearch {
    FindEquilibrium find;
    double tolerable;  // admissible difference between strain energy and work of a piece
    int halvings;
};

// A step that takes this many iterations may contain a jump, even if the energies at its ends agree.
inline constexpr int many_iterations = 7;

// Computes the work from one equilibrium to another if the trapezoidal rule over the whole step differs too
// much from the strain energy, or the step took many iterations. It halves the step, and then each half that
// does not agree, as often as `search` admits. The loss of a jump remains, since equilibria in between do not
// reduce it. If a jump passes several equilibria, the energies at its ends can agree by accident.
StepWork integrate_path(const PathPoint& from, const PathPoint& to, const PathSearch& search);

}  // namespace gxrod
