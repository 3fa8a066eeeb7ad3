#pragma once

#include <optional>

#include "linear/eigen/band_lanczos.hpp"

namespace gxrod {

// The lowest eigenvalues μ of K φ = μ M φ, both symmetric, M without negative eigenvalues; K may be singular
// or have negative ones.
struct LowestPairs {
    static constexpr double usual_residual = 1e-6;
    Eigen::VectorXd values;   // ascending
    Eigen::MatrixXd vectors;  // φᵀ M φ = 1, orthogonal by M
    Eigen::VectorXd
        residuals;       // an eigenvalue lies this near to each, relative to its distance from the shift
    double shift = 0.0;  // below all eigenvalues
    // The pivots of K − limit M count `counted` eigenvalues below the limit, of which `found` were found; −1:
    // not counted.
    double limit = 0.0;
    std::int64_t counted = -1;
    std::int64_t found = 0;
    bool is_all = false;  // there are no other finite eigenvalues

    bool complete() const {
        return counted == found && (residuals.size() == 0 || residuals.maxCoeff() < usual_residual);
    }
};

// Finds the `count` lowest pairs, or those below a bound. `multipliers` unknowns are multipliers, whose
// negative eigenvalues do not count. Returns nothing if M vanishes or no shift below all eigenvalues is
// found.
std::optional<LowestPairs> find_lowest_pairs(const SparsePattern& pattern,
                                             const std::vector<double>& K,
                                             const std::vector<double>& M,
                                             int count,
                                             std::optional<double> below = {},
                                             const ThreadTeam& team = ThreadTeam::alone(),
                                             std::int64_t multipliers = 0);

}  // namespace gxrod
