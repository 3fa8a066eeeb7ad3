#pragma once

#include <Eigen/Core>

// Cross products of a vector with the columns or rows of a matrix. Real is double, or several of them that
// are worked on at once.
namespace gxrod {

// [a]×, with [a]× b = a × b.
template <class Real>
Eigen::Matrix<Real, 3, 3> cross_matrix(const Eigen::Matrix<Real, 3, 1>& a) {
    Eigen::Matrix<Real, 3, 3> A;
    A << Real(0.0), -a[2], a[1], a[2], Real(0.0), -a[0], -a[1], a[0], Real(0.0);
    return A;
}

// [a]× B.
template <class Real>
Eigen::Matrix<Real, 3, 3> cross_columns(const Eigen::Matrix<Real, 3, 1>& a,
                                        const Eigen::Matrix<Real, 3, 3>& B) {
    Eigen::Matrix<Real, 3, 3> product;
    for (int j = 0; j < 3; ++j) product.col(j) = a.cross(B.col(j));
    return product;
}

// B [a]×.
template <class Real>
Eigen::Matrix<Real, 3, 3> cross_rows(const Eigen::Matrix<Real, 3, 3>& B, const Eigen::Matrix<Real, 3, 1>& a) {
    Eigen::Matrix<Real, 3, 3> product;
    for (int i = 0; i < 3; ++i) product.row(i) = B.row(i).cross(a);
    return product;
}

}  // namespace gxrod
