#pragma once

#include "linear/eigen/pencil.hpp"

namespace gxrod {

// Eigenpairs of a pencil, vectors of length 1 and orthogonal in its inner product.
struct EigenPairs {
    Eigen::VectorXd values;   // θ, by falling |θ|
    Eigen::MatrixXd vectors;  // a column each
    bool exhausted = false;   // there are no others but θ = 0
};

struct LanczosSettings {
    int wanted = 1;
    int block = 2;            // start vectors: copies of a multiple eigenvalue that can be found at once
    double tolerance = 1e-9;  // relative to θ, for a pair's residual
    int most_products = 3000;
};

// Finds the eigenpairs of largest |θ|, except those whose vectors are `known`; fewer than wanted if there are
// no more or they do not converge.
//
// It is Lanczos' method from several start vectors (Ruhe 1979), each new vector made orthogonal to all. When
// the basis is full it restarts from the best Ritz vectors and their couplings to the rest (thick restart, Wu
// & Simon 2000).
EigenPairs find_largest(const Pencil& pencil,
                        const LanczosSettings& settings,
                        const Eigen::MatrixXd& known = {});

// Adds pairs to others, keeping the order.
void merge(const EigenPairs& more, EigenPairs& pairs);

}  // namespace gxrod
