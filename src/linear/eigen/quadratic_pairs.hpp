#pragma once

#include <optional>

#include "linear/eigen/quadratic_problem.hpp"
#include "parallel/thread_team.hpp"

namespace gxrod {

// Eigenvalues λ of a quadratic problem with Im λ ≥ 0; of the others each is the conjugate of one of these.
// Where something relaxes, those that creep are left out.
struct QuadraticPairs {
    Eigen::VectorXcd values;  // by rising distance from the shift
    Eigen::MatrixXcd vectors;
    Eigen::MatrixXcd left;      // y, yᵀ T(λ) = 0, if asked for; zero where none was found
    Eigen::VectorXd residuals;  // of S⁻¹ T(λ) x, S that at the shift, relative to x
    double shift = 0.0;         // real; 0, but where K is singular or something relaxes
    // So far from the shift all have been sought; so many more lie within as the determinant counts them,
    // conjugates counted too. −1: not counted.
    double radius = 0.0;
    std::int64_t missing = -1;
    bool is_all = false;     // there are no other finite eigenvalues
    std::int64_t steps = 0;  // of Arnoldi's method
};

struct QuadraticSettings {
    int wanted = 1;
    bool counts = true;  // looks for those that were missed
    // Those farther away that seem to grow, so far as rough values show it, are sought too.
    bool follows_growth = true;
    double tolerance = 1e-11;  // of a pair's residual, relative
    bool left = false;
    std::int64_t first_steps = 0;  // before it looks at what it has; 0: by the number wanted
};

// The eigenvalues nearest to the shift, at least as many as wanted, fewer if there are no more or they do not
// converge. Empty if nothing has inertia.
std::optional<QuadraticPairs> find_nearest_pairs(const QuadraticProblem& problem,
                                                 const QuadraticSettings& settings,
                                                 const ThreadTeam& team = ThreadTeam::alone());

}  // namespace gxrod
