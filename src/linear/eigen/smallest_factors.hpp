#pragma once

#include "linear/eigen/band_lanczos.hpp"

namespace gxrod {

// The smallest factors λ, of either sign, for which (K + λ S) φ = 0 has a solution, K symmetric and positive
// definite, S symmetric.
struct SmallestFactors {
    bool is_definite = true;  // whether K is positive definite; otherwise nothing else is set
    Eigen::VectorXd
        values;  // by rising |λ|: as many positive ones as asked for, and the negative ones between
    Eigen::MatrixXd vectors;    // φᵀ K φ = 1
    Eigen::VectorXd residuals;  // relative
    // The pivots of K ± limit S count the `counted` factors up to this limit on either side of zero, of which
    // `found` were found; −1: not counted.
    double limit = 0.0;
    std::int64_t counted_positive = -1, counted_negative = -1;
    std::int64_t found_positive = 0, found_negative = 0;

    bool complete() const { return counted_positive == found_positive && counted_negative == found_negative; }
};

SmallestFactors find_smallest_factors(const SparsePattern& pattern,
                                      const std::vector<double>& K,
                                      const std::vector<double>& S,
                                      int count,
                                      const ThreadTeam& team = ThreadTeam::alone(),
                                      std::int64_t multipliers = 0);

}  // namespace gxrod
