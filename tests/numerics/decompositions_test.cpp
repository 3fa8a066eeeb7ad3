#include "numerics/eigenvalues.hpp"
#include "numerics/singular_values.hpp"
#include "tools/catch.hpp"
#include "tools/random_values.hpp"

using namespace gxrod;
using namespace gxrod::tools;

namespace {

Eigen::MatrixXd make_matrix(Eigen::Index rows, Eigen::Index columns, unsigned seed) {
    RandomValues random(seed);
    Eigen::MatrixXd A(rows, columns);
    for (double& one : A.reshaped()) one = random.number(-1.0, 1.0);
    return A;
}

}  // namespace

TEST_CASE("Complex eigenvalues and vectors are those of the matrix", "[numerics]") {
    const Eigen::MatrixXd A = make_matrix(9, 9, 1);
    const ComplexEigen found = find_complex_eigen(A);
    const Eigen::MatrixXcd images = found.vectors * found.values.asDiagonal();
    CHECK((A * found.vectors - images).norm() < 1e-13);
    CHECK((found.vectors.colwise().norm().array() - 1.0).abs().maxCoeff() < 1e-14);
    Eigen::Matrix2d spiral;
    spiral << 3.0, -4.0, 4.0, 3.0;
    const Eigen::VectorXcd values = find_complex_eigen(spiral).values;
    CHECK(std::abs(values[0] - std::complex<double>(3.0, 4.0)) < 1e-14);
    CHECK(values[1] == std::conj(values[0]));
}

TEST_CASE("Eigenvalues of two symmetric matrices make their difference singular", "[numerics]") {
    const Eigen::MatrixXd half = make_matrix(6, 6, 2), other = make_matrix(6, 6, 3);
    const Eigen::MatrixXd A = half + half.transpose();
    const Eigen::MatrixXd B = other * other.transpose() + 0.1 * Eigen::MatrixXd::Identity(6, 6);
    const auto values = find_generalized_eigenvalues(A, B);
    REQUIRE(values);
    for (Eigen::Index i = 0; i < 6; ++i) {
        const Eigen::VectorXd left = find_singular_values(A - (*values)[i] * B).values;
        CHECK(left[5] < 1e-13 * left[0]);
        if (i > 0) CHECK((*values)[i] > (*values)[i - 1]);
    }
    CHECK_FALSE(find_generalized_eigenvalues(A, -B));
}

TEST_CASE("Singular values and vectors are those of the matrix", "[numerics]") {
    // Wide, high, and large enough for the method that divides.
    for (const auto& [rows, columns] : {std::pair(3, 6), std::pair(6, 3), std::pair(40, 30)}) {
        Eigen::MatrixXd A = make_matrix(rows, columns, 4);
        A.col(1) = 2.0 * A.col(0);
        if (columns == 3) A.col(2) = A.col(1) - A.col(0);
        const SingularValues found = find_singular_values(A);
        CHECK(found.rank(1e-12) == (columns == 3 ? 1 : std::min(rows, columns - 1)));
        REQUIRE(found.left.rows() == rows);
        REQUIRE(found.left.cols() == rows);
        CHECK((found.left.transpose() * found.left - Eigen::MatrixXd::Identity(rows, rows)).norm() < 1e-13);
        Eigen::VectorXd squares = Eigen::VectorXd::Zero(rows);
        squares.head(found.values.size()) = found.values.cwiseAbs2();
        CHECK((A * A.transpose() * found.left - found.left * squares.asDiagonal()).norm() < 1e-11);
    }
    CHECK(find_singular_values(Eigen::MatrixXd::Zero(4, 2)).rank(1e-9) == 0);
}
