#pragma once

#include <Eigen/Core>
#include <array>

#include "assembly/system.hpp"
#include "state/records/mode_record.hpp"

namespace gxrod {

// What resists motions of the model in one piece, along the axes and about them through the origin.
struct WholeInertia {
    std::array<Eigen::VectorXd, 6> forces;  // M times each, of the unknowns
    Vec6 total = Vec6::Zero();              // masses and moments of inertia, held nodes included
};
WholeInertia compute_whole_inertia(const System& system, const State& state, double time);

// A solution as a shape of the trial motions, with its shares and words. Its sign makes the largest component
// of its displacements positive, the first of several that are as large; of its rotations if nothing is
// displaced.
Shape make_shape(const System& system, const State& state, const Eigen::VectorXd& solution);

// The same, and its largest displacement, or rotation if nothing is displaced, is 1.
Shape make_unit_shape(const System& system, const State& state, const Eigen::VectorXd& solution);

}  // namespace gxrod
