#pragma once

#include "linear/eigen/band_lanczos.hpp"

namespace gxrod {

// The smallest factors λ, of either sign, at which K + λ S φ = 0 has a solution, K symmetric and positive
// definite, S symmetric.
struct SmallestFactors {
    bool is_definite = true;  // whether K is; otherwise nothing else is set
    Eigen::VectorXd
        values;  // by rising |λ|: the asked number of positive ones, and the negative ones between
    Eigen::MatrixXd vectors;    // φᵀ K φ = 1
    Eigen::VectorXd residuals;  // relative
    // Up to so far from zero either way lie so many, as the pivots of K ± limit S count them, and so many
    // were found; −1: not counted.
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
