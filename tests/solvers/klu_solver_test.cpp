#include "solvers/klu_solver.hpp"

#include <Eigen/LU>
#include <catch2/catch.hpp>

#include "tools/difference.hpp"
#include "tools/random_values.hpp"

using namespace gxrod;
using namespace gxrod::tools;

namespace {

// A matrix as a solver takes it.
struct Sparse {
    SparsePattern pattern;
    std::vector<double> values;
};

// The non-zero entries of a dense matrix.
Sparse make_sparse(const Eigen::MatrixXd& dense) {
    Sparse sparse;
    sparse.pattern.column_starts.push_back(0);
    for (int column = 0; column < dense.cols(); ++column) {
        for (int row = 0; row < dense.rows(); ++row) {
            if (dense(row, column) == 0.0) continue;
            sparse.pattern.rows.push_back(row);
            sparse.values.push_back(dense(row, column));
        }
        sparse.pattern.column_starts.push_back(sparse.pattern.nonzeros());
    }
    return sparse;
}

// Sparse, unsymmetric, most diagonals zero.
Eigen::MatrixXd make_matrix(int size, unsigned seed) {
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

constexpr int size = 40;

}  // namespace

TEST_CASE("KLU solves as a dense LU does", "[solvers]") {
    for (unsigned seed = 1; seed <= 5; ++seed) {
        const Eigen::MatrixXd dense = make_matrix(size, seed);
        const Sparse sparse = make_sparse(dense);
        KluSolver solver(sparse.pattern);
        REQUIRE(solver.factorize(sparse.values).regular);
        const Eigen::VectorXd exact = Eigen::VectorXd::LinSpaced(size, -1.0, 2.0);
        Eigen::VectorXd x = dense * exact;
        const Eigen::VectorXd expected = dense.fullPivLu().solve(x);
        solver.solve(x);
        CHECK(relative_difference(x, expected) < 1e-11);
        CHECK(relative_difference(x, exact) < 1e-11);
    }
}

TEST_CASE("one KLU solver takes new values, and equal values give equal bits", "[solvers]") {
    const Sparse first = make_sparse(make_matrix(size, 1));
    Sparse second = first;
    for (double& value : second.values) value = 1.0 / value;
    KluSolver solver(first.pattern);
    const Eigen::VectorXd load = Eigen::VectorXd::Ones(size);
    Eigen::VectorXd x = load;
    REQUIRE(solver.factorize(first.values).regular);
    solver.solve(x);
    Eigen::VectorXd other = load;
    REQUIRE(solver.factorize(second.values).regular);
    solver.solve(other);
    Eigen::VectorXd again = load;
    REQUIRE(solver.factorize(first.values).regular);
    solver.solve(again);
    CHECK(x == again);
    CHECK_FALSE(x.isApprox(other));
}

TEST_CASE("a singular matrix names the equation without a pivot", "[solvers]") {
    Eigen::MatrixXd dense = make_matrix(size, 1);
    dense.row(17).setZero();
    dense.col(17).setZero();
    dense(17, 17) = 1.0;
    Sparse sparse = make_sparse(dense);
    KluSolver solver(sparse.pattern);
    REQUIRE(solver.factorize(sparse.values).regular);
    sparse.values[sparse.pattern.slot(17, 17)] = 0.0;
    const Factorization factorization = solver.factorize(sparse.values);
    CHECK_FALSE(factorization.regular);
    CHECK(factorization.singular_equation == 17);
    // The solver recovers.
    sparse.values[sparse.pattern.slot(17, 17)] = 2.0;
    CHECK(solver.factorize(sparse.values).regular);
}

TEST_CASE("dependent equations are found singular", "[solvers]") {
    Eigen::MatrixXd dense(3, 3);
    dense << 1.0, 2.0, 3.0, 2.0, 4.0, 6.0, 1.0, 0.0, 1.0;
    const Sparse sparse = make_sparse(dense);
    const Factorization factorization = KluSolver(sparse.pattern).factorize(sparse.values);
    CHECK_FALSE(factorization.regular);
    CHECK(factorization.singular_equation >= 0);
}

TEST_CASE("a matrix with an empty column is found singular", "[solvers]") {
    Eigen::MatrixXd dense = Eigen::MatrixXd::Identity(4, 4);
    dense(2, 2) = 0.0;
    const Sparse sparse = make_sparse(dense);
    const Factorization factorization = KluSolver(sparse.pattern).factorize(sparse.values);
    CHECK_FALSE(factorization.regular);
    CHECK(factorization.singular_equation == 2);
}

TEST_CASE("a system without equations is solved", "[solvers]") {
    SparsePattern pattern;
    pattern.column_starts.push_back(0);
    const auto solver = make_linear_solver(LinearSolverKind::automatic, pattern);
    CHECK(solver->factorize({}).regular);
    Eigen::VectorXd nothing(0);
    solver->solve(nothing);
    CHECK(nothing.size() == 0);
}
