#pragma once

#include "assembly/system.hpp"
#include "tools/random_values.hpp"

// A small model with everything in it, in random finite motion: a rod of three elements on a ball joint, a
// body with offset on its end, a second body on a hinge of its own, loads of every frame, gravity.
namespace gxrod::tools {

constexpr int rod_end = 3;
constexpr int lone_node = 4;
Model make_sample_model();

// Finite rotations and displacements of a step, curved histories; rates as the integrator makes them are for
// the caller to set.
State make_sample_state(const System& system, unsigned seed);

// The matrix that values on a pattern stand for.
Eigen::MatrixXd make_dense(const SparsePattern& pattern, const std::vector<double>& values);

}  // namespace gxrod::tools
