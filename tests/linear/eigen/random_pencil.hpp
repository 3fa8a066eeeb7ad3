#pragma once

#include <numeric>
#include <random>

#include "linear/sparse_pattern.hpp"
#include "tools/dense_algebra.hpp"

// Symmetric pencils whose eigenvalues are given.
namespace gxrod::tools {

// K φ = μ M φ of full matrices.
struct RandomPencil {
    SparsePattern pattern;
    std::vector<double> K, M;
    Eigen::MatrixXd dense_K, dense_M;
};

inline std::vector<double> list_values(const Eigen::MatrixXd& matrix) {
    return {matrix.data(), matrix.data() + matrix.size()};
}

inline Eigen::MatrixXd make_random_matrix(std::mt19937_64& generator,
                                          Eigen::Index rows,
                                          Eigen::Index columns) {
    Eigen::MatrixXd matrix(rows, columns);
    std::uniform_real_distribution<double> number(-1.0, 1.0);
    for (double& entry : matrix.reshaped()) entry = number(generator);
    return matrix;
}

// As many unknowns as eigenvalues; an infinite one is a motion without inertia.
inline RandomPencil make_pencil(const Eigen::VectorXd& eigenvalues) {
    std::mt19937_64 generator(7);
    const Eigen::Index size = eigenvalues.size();
    // Φᵀ K Φ and Φᵀ M Φ diagonal for Φ = Q⁻¹.
    const Eigen::MatrixXd turned = make_orthonormal(make_random_matrix(generator, size, size));
    const Eigen::MatrixXd Q =
        turned + 0.3 / std::sqrt(static_cast<double>(size)) * make_random_matrix(generator, size, size);
    Eigen::VectorXd k = eigenvalues, m = Eigen::VectorXd::Ones(size);
    for (Eigen::Index i = 0; i < size; ++i) {
        if (std::isfinite(eigenvalues[i])) continue;
        k[i] = 1.0;
        m[i] = 0.0;
    }
    RandomPencil pencil;
    std::vector<std::int64_t> rows(static_cast<std::size_t>(size));
    std::iota(rows.begin(), rows.end(), 0);
    pencil.pattern.add_columns(size, rows);
    pencil.dense_K = Q.transpose() * k.asDiagonal() * Q;
    pencil.dense_M = Q.transpose() * m.asDiagonal() * Q;
    pencil.K = list_values(pencil.dense_K);
    pencil.M = list_values(pencil.dense_M);
    return pencil;
}

}  // namespace gxrod::tools
