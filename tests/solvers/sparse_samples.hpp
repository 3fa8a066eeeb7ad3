#pragma once

#include <Eigen/Core>

#include "assembly/node_groups.hpp"
#include "linear/linear_solver.hpp"

// Matrices for the tests of linear solvers.
namespace gxrod::tools {

// A matrix as a solver takes it.
struct Sparse {
    SparsePattern pattern;
    std::vector<double> values;
};

// The non-zero entries of a dense matrix.
Sparse make_sparse(const Eigen::MatrixXd& dense);

// Sparse and regular, most diagonals zero.
Eigen::MatrixXd make_unsymmetric_matrix(int size, unsigned seed);
// Sparse, symmetric and regular, with eigenvalues of both signs.
Eigen::MatrixXd make_indefinite_matrix(int size, unsigned seed);

// The two-node elements between neighbours of a net with width × height nodes; of width 1, a rod.
std::vector<NodeGroup> make_net_groups(int width, int height);
SparsePattern make_net_pattern(int width, int height);
// Regular as long as few entries share a column, with entries of both signs.
std::vector<double> make_unsymmetric_values(const SparsePattern& pattern, unsigned seed);
// Symmetric and positive definite, on a pattern that is symmetric.
std::vector<double> make_stiffness_values(const SparsePattern& pattern, unsigned seed);

Eigen::VectorXd multiply(const SparsePattern& pattern,
                         const std::vector<double>& values,
                         const Eigen::VectorXd& x);

}  // namespace gxrod::tools
