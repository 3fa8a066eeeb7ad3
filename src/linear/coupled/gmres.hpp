#pragma once

#include <Eigen/Core>
#include <cmath>
#include <limits>

namespace gxrod {

struct GmresResult {
    bool converged = false;
    int iterations = 0;
};

// Solves A x = b from x = 0 by GMRES (Saad and Schultz, 1986) without restart, until |b − A x| is at most
// `tolerance`. apply(v) returns A v.
template <class Apply>
GmresResult solve_by_gmres(
    const Apply& apply, const Eigen::VectorXd& b, double tolerance, int most_iterations, Eigen::VectorXd& x) {
    GmresResult result;
    x.setZero(b.size());
    double residual = b.norm();
    if (!std::isfinite(residual)) return result;
    if (residual <= tolerance) {
        result.converged = true;
        return result;
    }
    Eigen::MatrixXd basis(b.size(), most_iterations + 1);
    basis.col(0) = b / residual;
    // The Hessenberg matrix, turned into an upper triangle by rotations.
    Eigen::MatrixXd R = Eigen::MatrixXd::Zero(most_iterations + 1, most_iterations);
    Eigen::VectorXd cosines(most_iterations), sines(most_iterations);
    Eigen::VectorXd right = Eigen::VectorXd::Zero(most_iterations + 1);
    right[0] = residual;
    int& k = result.iterations;
    while (k < most_iterations && residual > tolerance) {
        Eigen::VectorXd next = apply(basis.col(k));
        auto column = R.col(k);
        // Orthogonalizes again if most of the vector is removed, so that the basis stays orthogonal.
        for (double before = std::numeric_limits<double>::infinity(); next.norm() < 0.5 * before;) {
            before = next.norm();
            const Eigen::VectorXd shares = basis.leftCols(k + 1).transpose() * next;
            next.noalias() -= basis.leftCols(k + 1) * shares;
            column.head(k + 1) += shares;
        }
        const double size = next.norm();
        for (int i = 0; i < k; ++i) {
            const double upper = column[i];
            column[i] = cosines[i] * upper + sines[i] * column[i + 1];
            column[i + 1] = cosines[i] * column[i + 1] - sines[i] * upper;
        }
        const double length = std::hypot(column[k], size);
        if (!(length > 0.0) || !std::isfinite(length)) return result;
        cosines[k] = column[k] / length;
        sines[k] = size / length;
        column[k] = length;
        right[k + 1] = -sines[k] * right[k];
        right[k] *= cosines[k];
        residual = std::abs(right[k + 1]);
        ++k;
        if (size == 0.0) break;
        basis.col(k) = next / size;
    }
    result.converged = residual <= tolerance;
    x = basis.leftCols(k) * R.topLeftCorner(k, k).triangularView<Eigen::Upper>().solve(right.head(k));
    return result;
}

}  // namespace gxrod
