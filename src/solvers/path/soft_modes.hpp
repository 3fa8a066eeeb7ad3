#pragma once

#include <Eigen/Core>

#include "linear/linear_solver.hpp"

namespace gxrod {

// Eigenvalues μ of K x = μ W x closest to zero, ascending, and their vectors with xᵀ W x = 1; W is diagonal.
struct SoftModes {
    Eigen::VectorXd values;
    Eigen::MatrixXd vectors;
};

// Finds them by inverse iteration on a few vectors at once, from `start` if it has columns. The solver has
// the factors of K, and `values` its values. If K is unsymmetric, finds a single real one.
SoftModes find_soft_modes(LinearSolver& solver,
                          const SparsePattern& pattern,
                          const std::vector<double>& values,
                          const Eigen::VectorXd& weights,
                          int count,
                          bool is_symmetric,
                          const Eigen::MatrixXd& start = {});

// A measure of how close K is to singular in one direction alone: the eigenvalue μ closest to zero over the
// next one, both estimated by a few solutions, and its vector with xᵀ W x = 1. The ratio is 1 if not known.
struct LoneSoftness {
    double ratio = 1.0;
    Eigen::VectorXd vector;
};
LoneSoftness estimate_lone_softness(LinearSolver& solver, const Eigen::VectorXd& weights);

}  // namespace gxrod
