#include "solvers/path/soft_modes.hpp"

#include <Eigen/Cholesky>
#include <algorithm>
#include <cmath>
#include <numeric>
#include <vector>

#include "numerics/eigenvalues.hpp"
#include "solvers/path/bordered_solve.hpp"

namespace gxrod {

namespace {

// Components of both signs and any size, so that no vector that is sought is orthogonal to all of them.
Eigen::MatrixXd make_start(Eigen::Index size, Eigen::Index columns) {
    Eigen::MatrixXd start(size, columns);
    for (Eigen::Index j = 0; j < columns; ++j) {
        for (Eigen::Index i = 0; i < size; ++i) {
            const auto number = static_cast<double>((i * i + 17 * j) % 1009);
            start(i, j) = std::sin(1.0 + static_cast<double>(j) + 0.7 * number);
        }
    }
    return start;
}

// Makes the columns orthonormal in W.
void orthonormalize(const Eigen::VectorXd& weights, Eigen::MatrixXd& x) {
    for (int pass = 0; pass < 2; ++pass) {
        for (Eigen::Index j = 0; j < x.cols(); ++j) {
            for (Eigen::Index i = 0; i < j; ++i)
                x.col(j) -= x.col(i).dot(weights.cwiseProduct(x.col(j))) * x.col(i);
            x.col(j) /= std::sqrt(x.col(j).dot(weights.cwiseProduct(x.col(j))));
        }
    }
}

// K⁻¹ W x.
Eigen::MatrixXd iterate(LinearSolver& solver, const Eigen::VectorXd& weights, const Eigen::MatrixXd& x) {
    Eigen::MatrixXd y(x.rows(), x.cols());
    for (Eigen::Index j = 0; j < x.cols(); ++j) {
        Eigen::VectorXd column = weights.cwiseProduct(x.col(j));
        solver.solve(column);
        y.col(j) = column;
    }
    return y;
}

// Of Ritz pairs (μ, vector), those so many closest to zero.
SoftModes select(const Eigen::VectorXd& values, const Eigen::MatrixXd& vectors, int count) {
    std::vector<Eigen::Index> order(static_cast<std::size_t>(values.size()));
    std::iota(order.begin(), order.end(), 0);
    std::sort(order.begin(), order.end(), [&](auto a, auto b) {
        return std::abs(values[a]) < std::abs(values[b]);
    });
    order.resize(static_cast<std::size_t>(count));
    std::sort(order.begin(), order.end(), [&](auto a, auto b) { return values[a] < values[b]; });
    SoftModes modes{Eigen::VectorXd(count), Eigen::MatrixXd(vectors.rows(), count)};
    for (int i = 0; i < count; ++i) {
        modes.values[i] = values[order[static_cast<std::size_t>(i)]];
        modes.vectors.col(i) = vectors.col(order[static_cast<std::size_t>(i)]);
    }
    return modes;
}

}  // namespace

SoftModes find_soft_modes(LinearSolver& solver,
                          const SparsePattern& pattern,
                          const std::vector<double>& values,
                          const Eigen::VectorXd& weights,
                          int count,
                          bool is_symmetric,
                          const Eigen::MatrixXd& start) {
    constexpr int most_iterations = 60;
    constexpr double settled = 1e-10;
    constexpr Eigen::Index spare = 2;  // vectors beyond those sought, which make it converge
    const Eigen::Index columns = is_symmetric ? std::min(weights.size(), count + spare) : Eigen::Index{1};
    Eigen::MatrixXd x = make_start(weights.size(), columns);
    const Eigen::Index known = std::min(columns, start.cols());
    if (known > 0) x.leftCols(known) = start.leftCols(known);
    orthonormalize(weights, x);
    SoftModes modes;
    Eigen::VectorXd before;
    for (int iteration = 0; iteration < most_iterations; ++iteration) {
        x = iterate(solver, weights, x);
        if (!x.allFinite()) break;
        orthonormalize(weights, x);
        // By K itself: its round-off is less than that of its inverse.
        Eigen::MatrixXd image(x.rows(), x.cols());
        for (Eigen::Index j = 0; j < x.cols(); ++j) image.col(j) = multiply(pattern, values, x.col(j));
        const Eigen::MatrixXd projected = x.transpose() * image;
        const SymmetricEigen ritz = find_symmetric_eigen(0.5 * (projected + projected.transpose()));
        x = (x * ritz.vectors).eval();
        modes = select(ritz.values, x, static_cast<int>(std::min<Eigen::Index>(count, columns)));
        const double scale = modes.values.cwiseAbs().maxCoeff();
        if (before.size() == modes.values.size() &&
            (modes.values - before).cwiseAbs().maxCoeff() <= settled * scale)
            break;
        before = modes.values;
    }
    return modes;
}

LoneSoftness estimate_lone_softness(LinearSolver& solver, const Eigen::VectorXd& weights) {
    if (weights.size() < 2) return {};
    const auto norm = [&](const Eigen::VectorXd& x) { return std::sqrt(x.dot(weights.cwiseProduct(x))); };
    Eigen::MatrixXd x = make_start(weights.size(), 2);
    orthonormalize(weights, x);
    double softness = 0.0, next = 0.0;  // 1/|μ|
    for (int iteration = 0; iteration < 3; ++iteration) {
        x = iterate(solver, weights, x);
        if (!x.allFinite()) return {};
        softness = norm(x.col(0));
        x.col(0) /= softness;
        // Twice, for the second vector is all but parallel to the first one.
        for (int pass = 0; pass < 2; ++pass)
            x.col(1) -= x.col(0).dot(weights.cwiseProduct(x.col(1))) * x.col(0);
        next = norm(x.col(1));
        x.col(1) /= next;
    }
    if (!std::isfinite(next / softness)) return {};
    return {next / softness, x.col(0)};
}

}  // namespace gxrod
