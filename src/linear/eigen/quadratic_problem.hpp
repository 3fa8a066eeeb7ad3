#pragma once

#include <Eigen/Core>
#include <complex>
#include <vector>

#include "linear/sparse_pattern.hpp"

namespace gxrod {

// (λ² M + λ D + K) x = 0, real matrices of any symmetry by their values on one pattern. The pattern must
// outlive it.
struct QuadraticProblem {
    const SparsePattern* pattern;
    std::vector<double> K, D, M;

    std::int64_t size() const { return pattern->size(); }
    // K + λ D + λ² M.
    std::vector<double> at(double lambda) const;
    std::vector<std::complex<double>> at(std::complex<double> lambda) const;
    // Its matrices transposed: the right vectors of that are left vectors y of this, yᵀ (λ² M + λ D + K) = 0.
    QuadraticProblem transposed() const;
};

}  // namespace gxrod
