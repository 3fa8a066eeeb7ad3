// Properties that every linear solver has.
#include <cmath>
#include <limits>

#include "solvers/sparse_samples.hpp"
#include "tools/catch.hpp"
#include "tools/dense_algebra.hpp"
#include "tools/difference.hpp"
#include "tools/random_values.hpp"

using namespace gxrod;
using namespace gxrod::tools;

namespace {

constexpr int size = 40;

// Calls visit(solver kind) for each.
template <class Visit>
void for_each_solver(Visit&& visit) {
    for (const LinearSolverKind kind :
         {LinearSolverKind::chains, LinearSolverKind::klu, LinearSolverKind::umfpack}) {
        INFO("solver " << static_cast<int>(kind));
        visit(kind);
    }
}

void check_solution(LinearSolver& solver, const Eigen::MatrixXd& dense, const Sparse& sparse) {
    REQUIRE(solver.factorize(sparse.values).regular);
    const Eigen::VectorXd exact = Eigen::VectorXd::LinSpaced(dense.rows(), -1.0, 2.0);
    Eigen::VectorXd x = dense * exact;
    const Eigen::VectorXd expected = solve_dense(dense, x);
    solver.solve(x);
    CHECK(relative_difference(x, expected) < 1e-11);
    CHECK(relative_difference(x, exact) < 1e-11);
}

Eigen::VectorXd solve_ones(LinearSolver& solver, const std::vector<double>& values) {
    REQUIRE(solver.factorize(values).regular);
    Eigen::VectorXd x = Eigen::VectorXd::Ones(size);
    solver.solve(x);
    return x;
}

}  // namespace

TEST_CASE("every solver solves a symmetric indefinite matrix as a dense LU does", "[solvers]") {
    for_each_solver([](LinearSolverKind kind) {
        for (unsigned seed = 1; seed <= 20; ++seed) {
            const Eigen::MatrixXd dense = make_indefinite_matrix(size, seed);
            const Sparse sparse = make_sparse(dense);
            const auto solver = make_linear_solver(kind, sparse.pattern);
            CHECK(solver->kind() == kind);
            check_solution(*solver, dense, sparse);
        }
    });
}

TEST_CASE("KLU and UMFPACK solve unsymmetric patterns with zeros on the diagonal", "[solvers]") {
    for (const LinearSolverKind kind : {LinearSolverKind::klu, LinearSolverKind::umfpack}) {
        for (unsigned seed = 1; seed <= 20; ++seed) {
            const Eigen::MatrixXd dense = make_unsymmetric_matrix(size, seed);
            const Sparse sparse = make_sparse(dense);
            check_solution(*make_linear_solver(kind, sparse.pattern), dense, sparse);
        }
    }
}

TEST_CASE("a pivot that is small compared with its column costs no digits", "[solvers]") {
    // Without a pivot search, [ε 1; 1 1] loses as many digits as 1/ε has.
    for_each_solver([](LinearSolverKind kind) {
        Eigen::MatrixXd dense = make_indefinite_matrix(size, 3);
        for (int i = 0; i < size; i += 2) {
            dense.row(i).setZero();
            dense.col(i).setZero();
            dense(i, i) = 1e-7;
            dense(i, i + 1) = dense(i + 1, i) = 1.0;
        }
        const Sparse sparse = make_sparse(dense);
        check_solution(*make_linear_solver(kind, sparse.pattern), dense, sparse);
    });
}

TEST_CASE("one solver takes new values, and equal values give equal bits", "[solvers]") {
    for_each_solver([](LinearSolverKind kind) {
        const Sparse first = make_sparse(make_indefinite_matrix(size, 1));
        Sparse second = first;
        for (double& value : second.values) value = 1.0 / value;
        Sparse singular = first;
        for (double& value : singular.values) value = 0.0;
        const auto solver = make_linear_solver(kind, first.pattern);
        const Eigen::VectorXd x = solve_ones(*solver, first.values);
        const Eigen::VectorXd other = solve_ones(*solver, second.values);
        CHECK(solve_ones(*solver, first.values) == x);
        CHECK_FALSE(solver->factorize(singular.values).regular);
        CHECK(solve_ones(*solver, first.values) == x);
        CHECK(solve_ones(*make_linear_solver(kind, first.pattern), first.values) == x);
        CHECK_FALSE(x.isApprox(other));
    });
}

TEST_CASE("a singular matrix names the equation without a pivot", "[solvers]") {
    for_each_solver([](LinearSolverKind kind) {
        for (const int lone : {0, 17, size - 1}) {
            Eigen::MatrixXd dense = make_indefinite_matrix(size, 1);
            dense.row(lone).setZero();
            dense.col(lone).setZero();
            dense(lone, lone) = 1.0;
            Sparse sparse = make_sparse(dense);
            const auto solver = make_linear_solver(kind, sparse.pattern);
            REQUIRE(solver->factorize(sparse.values).regular);
            sparse.values[sparse.pattern.slot(lone, lone)] = 0.0;
            const Factorization factorization = solver->factorize(sparse.values);
            CHECK_FALSE(factorization.regular);
            CHECK(factorization.singular_equation == lone);
            // The solver recovers.
            sparse.values[sparse.pattern.slot(lone, lone)] = 2.0;
            CHECK(solver->factorize(sparse.values).regular);
        }
    });
}

TEST_CASE("dependent equations are found singular", "[solvers]") {
    for_each_solver([](LinearSolverKind kind) {
        Eigen::MatrixXd dense(3, 3);
        dense << 1.0, 2.0, 3.0, 2.0, 4.0, 6.0, 3.0, 6.0, 1.0;
        const Sparse sparse = make_sparse(dense);
        const Factorization factorization =
            make_linear_solver(kind, sparse.pattern)->factorize(sparse.values);
        CHECK_FALSE(factorization.regular);
        CHECK(factorization.singular_equation >= 0);
    });
}

TEST_CASE("a matrix with an empty column is found singular", "[solvers]") {
    for_each_solver([](LinearSolverKind kind) {
        Eigen::MatrixXd dense = Eigen::MatrixXd::Identity(4, 4);
        dense(2, 2) = 0.0;
        const Sparse sparse = make_sparse(dense);
        const Factorization factorization =
            make_linear_solver(kind, sparse.pattern)->factorize(sparse.values);
        CHECK_FALSE(factorization.regular);
        CHECK(factorization.singular_equation == 2);
    });
}

TEST_CASE("NaN does not pass for a solution", "[solvers]") {
    for (const double value :
         {std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::infinity()}) {
        for_each_solver([value](LinearSolverKind kind) {
            Sparse sparse = make_sparse(make_indefinite_matrix(size, 2));
            const std::vector<double> sound = sparse.values;
            sparse.values[sparse.pattern.slot(5, 5)] = value;
            sparse.values[sparse.pattern.block_of(6).first_entry] = value;
            const auto solver = make_linear_solver(kind, sparse.pattern);
            Eigen::VectorXd x = Eigen::VectorXd::Ones(size);
            const bool regular = solver->factorize(sparse.values).regular;
            if (regular) solver->solve(x);
            CHECK_FALSE((regular && x.allFinite()));
            CHECK(solve_ones(*solver, sound).allFinite());
        });
    }
}

TEST_CASE("a system without equations is solved", "[solvers]") {
    const SparsePattern pattern;
    for (const LinearSolverKind kind : {LinearSolverKind::automatic,
                                        LinearSolverKind::chains,
                                        LinearSolverKind::klu,
                                        LinearSolverKind::umfpack}) {
        const auto solver = make_linear_solver(kind, pattern);
        CHECK(solver->factorize({}).regular);
        Eigen::VectorXd nothing(0);
        solver->solve(nothing);
        CHECK(nothing.size() == 0);
    }
}

TEST_CASE("rods and nets are solved by blocks, what has no diagonal by KLU", "[solvers]") {
    const auto choose = [](const SparsePattern& pattern) {
        return make_linear_solver(LinearSolverKind::automatic, pattern)->kind();
    };
    for (const int height : {2, 10, 100}) {
        for (const int width : {1, 2, 6})
            CHECK(choose(make_net_pattern(width, height)) == LinearSolverKind::chains);
    }
    CHECK(choose(make_sparse(make_unsymmetric_matrix(size, 1)).pattern) == LinearSolverKind::klu);
}

TEST_CASE("KLU takes rods and small nets, UMFPACK matrices that fill", "[solvers]") {
    for (const int nodes : {2, 10, 100, 1000})
        CHECK(make_general_solver(make_net_pattern(1, nodes))->kind() == LinearSolverKind::klu);
    CHECK(make_general_solver(make_net_pattern(6, 6))->kind() == LinearSolverKind::klu);
    CHECK(make_general_solver(make_net_pattern(40, 40))->kind() == LinearSolverKind::umfpack);
}

TEST_CASE("all solvers agree on a net", "[solvers]") {
    const SparsePattern pattern = make_net_pattern(12, 12);
    const std::vector<double> values = make_stiffness_values(pattern, 4);
    const Eigen::VectorXd load = Eigen::VectorXd::LinSpaced(pattern.size(), 1.0, 2.0);
    Eigen::VectorXd expected = load;
    const auto klu = make_linear_solver(LinearSolverKind::klu, pattern);
    REQUIRE(klu->factorize(values).regular);
    klu->solve(expected);
    for_each_solver([&](LinearSolverKind kind) {
        const auto solver = make_linear_solver(kind, pattern);
        REQUIRE(solver->factorize(values).regular);
        Eigen::VectorXd x = load;
        solver->solve(x);
        CHECK(relative_difference(x, expected) < 1e-12);
        CHECK((tools::multiply(pattern, values, x) - load).norm() < 1e-12 * load.norm());
    });
}
