#include "solvers/sparse_samples.hpp"

#include "tools/random_values.hpp"

namespace gxrod::tools {

Sparse make_sparse(const Eigen::MatrixXd& dense) {
    Sparse sparse;
    for (int column = 0; column < dense.cols(); ++column) {
        std::vector<std::int64_t> rows;
        for (int row = 0; row < dense.rows(); ++row) {
            if (dense(row, column) == 0.0) continue;
            rows.push_back(row);
            sparse.values.push_back(dense(row, column));
        }
        sparse.pattern.add_columns(1, rows);
    }
    return sparse;
}

Eigen::MatrixXd make_unsymmetric_matrix(int size, unsigned seed) {
    RandomValues random(seed);
    Eigen::MatrixXd dense = Eigen::MatrixXd::Zero(size, size);
    for (int i = 0; i < size; ++i) {
        dense(i, (i + 1) % size) = random.number(1.0, 2.0);
        for (int j = 0; j < size; ++j) {
            if (random.number(0.0, 1.0) < 0.15) dense(i, j) += random.number(-1.0, 1.0);
        }
    }
    return dense;
}

Eigen::MatrixXd make_indefinite_matrix(int size, unsigned seed) {
    RandomValues random(seed);
    Eigen::MatrixXd dense = Eigen::MatrixXd::Zero(size, size);
    for (int i = 0; i < size; ++i) {
        dense(i, i) = (random.number(0.0, 1.0) < 0.3 ? -1.0 : 1.0) * random.number(1.0, 2.0);
        for (int j = 0; j < i; ++j) {
            if (random.number(0.0, 1.0) < 0.15) dense(i, j) = dense(j, i) = random.number(-1.0, 1.0);
        }
    }
    return dense;
}

std::vector<NodeGroup> make_net_groups(int width, int height) {
    std::vector<NodeGroup> groups;
    for (int y = 0; y < height; ++y) {
        for (int x = 0; x < width; ++x) {
            const int node = y * width + x;
            if (x + 1 < width) groups.push_back({node, node + 1});
            if (y + 1 < height) groups.push_back({node, node + width});
        }
    }
    return groups;
}

SparsePattern make_net_pattern(int width, int height) {
    Model model;
    model.nodes.resize(static_cast<std::size_t>(width) * static_cast<std::size_t>(height));
    const Supports none(model);
    return compute_pattern(EquationNumbers(none), make_net_groups(width, height));
}

std::vector<double> make_unsymmetric_values(const SparsePattern& pattern, unsigned seed) {
    RandomValues random(seed);
    std::vector<double> values(static_cast<std::size_t>(pattern.nonzeros()));
    pattern.visit_entries([&](std::int64_t row, std::int64_t column, std::int64_t slot) {
        values[slot] = random.number(-1.0, 1.0) + (row == column ? 20.0 : 0.0);
    });
    return values;
}

std::vector<double> make_stiffness_values(const SparsePattern& pattern, unsigned seed) {
    RandomValues random(seed);
    std::vector<double> values(static_cast<std::size_t>(pattern.nonzeros()), 0.0);
    pattern.visit_entries([&](std::int64_t i, std::int64_t j, std::int64_t slot) {
        if (i >= j) return;
        const double value = random.number(-1.0, 1.0);
        values[slot] = values[pattern.slot(j, i)] = value;
        values[pattern.slot(i, i)] += 1.01 * std::abs(value);
        values[pattern.slot(j, j)] += 1.01 * std::abs(value);
    });
    return values;
}

Eigen::VectorXd multiply(const SparsePattern& pattern,
                         const std::vector<double>& values,
                         const Eigen::VectorXd& x) {
    Eigen::VectorXd y = Eigen::VectorXd::Zero(x.size());
    pattern.visit_entries(
        [&](std::int64_t i, std::int64_t j, std::int64_t slot) { y[i] += values[slot] * x[j]; });
    return y;
}

}  // namespace gxrod::tools
