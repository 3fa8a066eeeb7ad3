#pragma once

#include <Eigen/Core>
#include <array>
#include <vector>

#include "assembly/system.hpp"
#include "state/records/mode_record.hpp"

namespace gxrod {

// The inertia of the model against rigid motions, along the axes and about them through the origin.
struct WholeInertia {
    std::array<Eigen::VectorXd, 6> forces;  // M times each rigid motion, by the unknowns
    Vec6 total = Vec6::Zero();              // masses and moments of inertia, held nodes included
};
WholeInertia compute_whole_inertia(const System& system, const State& state, double time);

// Makes a shape of the trial motions from a solution, with its shares and words. The largest component of its
// displacements is positive, the first of several equal ones; without displacements, the largest component of
// its rotations.
Shape make_shape(const System& system, const State& state, const Eigen::VectorXd& solution);

// Makes the shape with its largest displacement scaled to 1, or its largest rotation if nothing is displaced.
Shape make_unit_shape(const System& system, const State& state, const Eigen::VectorXd& solution);

// Returns the part of the energy xᴴ K x that is in the gaps of joints, whose equations yield by very little
// (docs/theory/joints.md, (J19)): next to 0 of a motion, 1 of what joints hold. Gaps of multipliers μ have
// −μ* K_μμ μ.
double measure_gap_share(const System& system, const std::vector<double>& K, const Eigen::VectorXcd& x);

}  // namespace gxrod
