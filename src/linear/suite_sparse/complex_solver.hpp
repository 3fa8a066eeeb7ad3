#pragma once

#include <Eigen/Core>
#include <complex>
#include <memory>
#include <vector>

#include "linear/sparse_pattern.hpp"

namespace gxrod {

// Solves complex systems on one pattern, by KLU of SuiteSparse.
class ComplexSolver {
  public:
    // Throws std::runtime_error if memory does not suffice; so do its members.
    explicit ComplexSolver(const SparsePattern& pattern);
    ~ComplexSolver();

    // Returns false if the matrix with these values on the pattern is singular.
    bool factorize(const std::vector<std::complex<double>>& values);
    // Replaces the right-hand side by the solution of the system, or of the transposed one.
    void solve(Eigen::VectorXcd& right_hand_side);
    void solve_transposed(Eigen::VectorXcd& right_hand_side);
    // Returns the determinant over its absolute value.
    std::complex<double> determinant_direction() const;

  private:
    struct Handles;
    std::unique_ptr<Handles> handles_;
    CompressedColumns columns_;
};

}  // namespace gxrod
