#include "deck/sections/section_matrices.hpp"

#include <fmt/format.h>

#include "deck/schema/choices.hpp"
#include "numerics/eigenvalues.hpp"

namespace gxrod {
namespace {

// Of entries, relative to the diagonal entries of their row and column.
constexpr double round_off = 1e-9;
// A matrix with a unit diagonal and an eigenvalue below this counts as not definite.
constexpr double zero_eigenvalue = 1e-12;

std::string entry_name(int row, int column) { return fmt::format("[{}][{}]", row, column); }

double scale_of(const Mat6& matrix, int row, int column) {
    return std::sqrt(matrix(row, row)) * std::sqrt(matrix(column, column));
}

std::optional<MatrixFault> check_diagonal(const Mat6& matrix) {
    for (int i = 0; i < 6; ++i) {
        if (matrix(i, i) > 0.0) continue;
        return MatrixFault{
            entry_name(i, i),
            fmt::format("expected a number greater than 0 on the diagonal, found {}", matrix(i, i))};
    }
    return std::nullopt;
}

std::optional<MatrixFault> check_symmetry(const Mat6& matrix) {
    for (int i = 0; i < 6; ++i) {
        for (int j = 0; j < i; ++j) {
            if (std::abs(matrix(i, j) - matrix(j, i)) <= round_off * scale_of(matrix, i, j)) continue;
            return MatrixFault{entry_name(i, j),
                               fmt::format("expected a symmetric matrix, found {} here and {} at {}",
                                           matrix(i, j),
                                           matrix(j, i),
                                           entry_name(j, i))};
        }
    }
    return std::nullopt;
}

// "x 1, rz −0.5": a direction, its largest component being 1.
std::string describe_direction(Vec6 direction) {
    Eigen::Index largest = 0;
    direction.cwiseAbs().maxCoeff(&largest);
    direction /= direction[largest];
    std::string text;
    for (int i = 0; i < 6; ++i) {
        if (std::abs(direction[i]) < 1e-6) continue;
        text += fmt::format("{}{} {:.4g}", text.empty() ? "" : ", ", component_names[i], direction[i]);
    }
    return text;
}

// The diagonal must be positive.
std::optional<MatrixFault> check_definiteness(const Mat6& matrix, const char* what) {
    const Vec6 scale = matrix.diagonal().cwiseSqrt().cwiseInverse();
    const Mat6 scaled = scale.asDiagonal() * matrix * scale.asDiagonal();
    const SymmetricEigen eigen = find_symmetric_eigen(scaled);
    if (eigen.values[0] > zero_eigenvalue) return std::nullopt;
    const Vec6 direction = scale.cwiseProduct(eigen.vectors.col(0));
    return MatrixFault{"",
                       fmt::format("expected a positive definite matrix; this one gives no energy to {} {}",
                                   what,
                                   describe_direction(direction))};
}

// Entry (row, column) of a slice's matrix other than mass and J, from the others: nullopt for those that are
// free.
std::optional<double> find_slice_entry(const Mat6& matrix, int row, int column) {
    if (column < 3) return row == column ? matrix(0, 0) : 0.0;
    if (row >= 3) return std::nullopt;
    if (row == column - 3) return 0.0;
    // The coupling is skew: its entries above the diagonal follow from those below.
    return row < column - 3 ? std::optional(-matrix(column - 3, row + 3)) : std::nullopt;
}

std::optional<MatrixFault> check_slice(const Mat6& matrix) {
    for (int row = 0; row < 3; ++row) {
        for (int column = row; column < 6; ++column) {
            const std::optional<double> expected = find_slice_entry(matrix, row, column);
            if (!expected) continue;
            if (std::abs(matrix(row, column) - *expected) <= round_off * scale_of(matrix, row, column))
                continue;
            return MatrixFault{
                entry_name(row, column),
                fmt::format(
                    "expected {} as in the inertia of a rigid slice, [m 1, −m [d]×; m [d]×, J], found {}",
                    *expected + 0.0,
                    matrix(row, column))};
        }
    }
    return std::nullopt;
}

void symmetrise(Mat6& matrix) { matrix = (0.5 * (matrix + matrix.transpose())).eval(); }

}  // namespace

std::optional<MatrixFault> check_stiffness_matrix(Mat6& matrix) {
    if (auto fault = check_diagonal(matrix)) return fault;
    if (auto fault = check_symmetry(matrix)) return fault;
    symmetrise(matrix);
    return check_definiteness(matrix, "the strain");
}

std::optional<MatrixFault> check_semidefinite_matrix(Mat6& matrix) {
    for (int i = 0; i < 6; ++i) {
        if (matrix(i, i) >= 0.0) continue;
        return MatrixFault{
            entry_name(i, i),
            fmt::format("expected no negative number on the diagonal, found {}", matrix(i, i))};
    }
    if (auto fault = check_symmetry(matrix)) return fault;
    symmetrise(matrix);
    const Vec6 scale =
        matrix.diagonal().unaryExpr([](double x) { return x > 0.0 ? 1.0 / std::sqrt(x) : 1.0; });
    const Mat6 scaled = scale.asDiagonal() * matrix * scale.asDiagonal();
    const SymmetricEigen eigen = find_symmetric_eigen(scaled);
    if (eigen.values[0] >= -zero_eigenvalue) return std::nullopt;
    const Vec6 direction = scale.cwiseProduct(eigen.vectors.col(0));
    return MatrixFault{
        "", "this matrix gives a negative energy to the displacement " + describe_direction(direction)};
}

std::optional<MatrixFault> check_mass_matrix(Mat6& matrix) {
    if (auto fault = check_diagonal(matrix)) return fault;
    if (auto fault = check_symmetry(matrix)) return fault;
    symmetrise(matrix);
    if (auto fault = check_slice(matrix)) return fault;
    return check_definiteness(matrix, "the motion");
}

}  // namespace gxrod
