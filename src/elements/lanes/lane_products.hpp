#pragma once

#include <Eigen/Core>

// Products of small matrices of lanes, column by column. Eigen's products become a call for every entry if
// the compiler does not inline them.
namespace gxrod {

// Combines the three columns of A with the entries of b.
template <class Real>
[[gnu::always_inline]] inline Eigen::Matrix<Real, 3, 1> combine(const Eigen::Matrix<Real, 3, 3>& A,
                                                                const Real& b0,
                                                                const Real& b1,
                                                                const Real& b2) {
    Eigen::Matrix<Real, 3, 1> sum;
    for (int i = 0; i < 3; ++i) sum[i] = A(i, 0) * b0 + A(i, 1) * b1 + A(i, 2) * b2;
    return sum;
}

// Computes A B.
template <class Real>
[[gnu::always_inline]] inline Eigen::Matrix<Real, 3, 3> multiply(const Eigen::Matrix<Real, 3, 3>& A,
                                                                 const Eigen::Matrix<Real, 3, 3>& B) {
    Eigen::Matrix<Real, 3, 3> product;
    for (int j = 0; j < 3; ++j) {
        const Eigen::Matrix<Real, 3, 1> column = combine(A, B(0, j), B(1, j), B(2, j));
        for (int i = 0; i < 3; ++i) product(i, j) = column[i];
    }
    return product;
}

// Computes A B + C D.
template <class Real>
[[gnu::always_inline]] inline Eigen::Matrix<Real, 3, 3> multiply(const Eigen::Matrix<Real, 3, 3>& A,
                                                                 const Eigen::Matrix<Real, 3, 3>& B,
                                                                 const Eigen::Matrix<Real, 3, 3>& C,
                                                                 const Eigen::Matrix<Real, 3, 3>& D) {
    Eigen::Matrix<Real, 3, 3> product;
    for (int j = 0; j < 3; ++j) {
        const Eigen::Matrix<Real, 3, 1> first = combine(A, B(0, j), B(1, j), B(2, j));
        const Eigen::Matrix<Real, 3, 1> second = combine(C, D(0, j), D(1, j), D(2, j));
        for (int i = 0; i < 3; ++i) product(i, j) = first[i] + second[i];
    }
    return product;
}

// Computes the transpose of A.
template <class Real>
[[gnu::always_inline]] inline Eigen::Matrix<Real, 3, 3> transpose(const Eigen::Matrix<Real, 3, 3>& A) {
    Eigen::Matrix<Real, 3, 3> transposed;
    for (int j = 0; j < 3; ++j) {
        for (int i = 0; i < 3; ++i) transposed(i, j) = A(j, i);
    }
    return transposed;
}

// Computes a A + b B.
template <class Real>
[[gnu::always_inline]] inline Eigen::Matrix<Real, 3, 3> mix(const Real& a,
                                                            const Eigen::Matrix<Real, 3, 3>& A,
                                                            const Real& b,
                                                            const Eigen::Matrix<Real, 3, 3>& B) {
    Eigen::Matrix<Real, 3, 3> sum;
    for (int j = 0; j < 3; ++j) {
        for (int i = 0; i < 3; ++i) sum(i, j) = a * A(i, j) + b * B(i, j);
    }
    return sum;
}

// Adds `added` to the block of `matrix` that begins at this row and column.
template <class Real, int Size>
[[gnu::always_inline]] inline void add_block(const Eigen::Matrix<Real, 3, 3>& added,
                                             int row,
                                             int column,
                                             Eigen::Matrix<Real, Size, Size>& matrix) {
    for (int j = 0; j < 3; ++j) {
        for (int i = 0; i < 3; ++i) matrix(row + i, column + j) += added(i, j);
    }
}

}  // namespace gxrod
