#pragma once

#include <optional>

#include "linear/eigen/quadratic_problem.hpp"
#include "parallel/thread_team.hpp"

namespace gxrod {

// Eigenvalues λ of a quadratic problem with Im λ ≥ 0; every other one is the conjugate of one of these. With
// relaxing stiffness, creeping ones are left out.
struct QuadraticPairs {
    Eigen::VectorXcd values;  // by rising distance from the shift
    Eigen::MatrixXcd vectors;
    Eigen::MatrixXcd left;      // y, yᵀ T(λ) = 0, if asked for; zero if not found
    Eigen::VectorXd residuals;  // S⁻¹ T(λ) x relative to x, with S at the shift
    double shift = 0.0;         // real; 0, unless K is singular or has relaxing parts
    // The radius around the shift of a complete search; the determinant counts `missing` more eigenvalues
    // within it, including conjugates. −1: not counted.
    double radius = 0.0;
    std::int64_t missing = -1;
    bool is_all = false;     // there are no other finite eigenvalues
    std::int64_t steps = 0;  // steps of Arnoldi's method
};

struct QuadraticSettings {
    int wanted = 1;
    bool counts = true;  // looks for eigenvalues that were missed
    // Whether farther ones that seem to grow, as far as rough values show it, are sought too.
    bool follows_growth = true;
    double tolerance = 1e-11;  // relative residual of a pair
    bool left = false;
    std::int64_t first_steps = 0;  // steps before it looks at the pairs; 0: by the number wanted
};

// Finds the eigenvalues nearest to the shift, at least as many as wanted, fewer if there are no more or they
// do not converge. Returns nothing if nothing has inertia.
std::optional<QuadraticPairs> find_nearest_pairs(const QuadraticProblem& problem,
                                                 const QuadraticSettings& settings,
                                                 const ThreadTeam& team = ThreadTeam::alone());

}  // namespace gxrod
