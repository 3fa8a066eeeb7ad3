#include "linear/eigen/quadratic_pairs.hpp"

#include <algorithm>
#include <cmath>

#include "linear/eigen/random_pencil.hpp"
#include "linear/eigen/zero_count.hpp"
#include "linear/suite_sparse/complex_solver.hpp"
#include "tools/catch.hpp"
#include "tools/dense_algebra.hpp"

using namespace gxrod;
using namespace gxrod::tools;

namespace {

using Complex = std::complex<double>;

struct DenseProblem {
    SparsePattern pattern;
    Eigen::MatrixXd K, D, M;

    QuadraticProblem sparse() const { return {&pattern, list_values(K), list_values(D), list_values(M)}; }
    Eigen::Index size() const { return K.rows(); }
};

SparsePattern make_full_pattern(Eigen::Index size) {
    SparsePattern pattern;
    std::vector<std::int64_t> rows(static_cast<std::size_t>(size));
    std::iota(rows.begin(), rows.end(), 0);
    pattern.add_columns(size, rows);
    return pattern;
}

// K with the given ω², a unit M, and these parts of random damping, circulation and gyroscopic matrices.
DenseProblem make_problem(const Eigen::VectorXd& squares,
                          double damping,
                          double circulation,
                          double gyroscopic) {
    std::mt19937_64 generator(11);
    const Eigen::Index size = squares.size();
    const Eigen::MatrixXd Q = make_orthonormal(make_random_matrix(generator, size, size));
    const auto random = [&] { return make_random_matrix(generator, size, size); };
    const Eigen::MatrixXd A = random(), B = random(), C = random();
    return {make_full_pattern(size),
            Q.transpose() * squares.asDiagonal() * Q + circulation * (A - A.transpose()),
            damping * B * B.transpose() + gyroscopic * (C - C.transpose()),
            Eigen::MatrixXd::Identity(size, size)};
}

// All eigenvalues with Im λ ≥ 0, by their distance from the shift.
std::vector<Complex> find_all(const DenseProblem& problem, double shift) {
    std::vector<Complex> all = find_quadratic_eigenvalues(problem.K, problem.D, problem.M);
    std::sort(all.begin(), all.end(), [&](Complex a, Complex b) {
        return std::abs(a - shift) < std::abs(b - shift);
    });
    return all;
}

void check_nearest(const DenseProblem& dense, int wanted) {
    const QuadraticProblem problem = dense.sparse();
    const auto pairs = find_nearest_pairs(problem, {.wanted = wanted, .follows_growth = false});
    REQUIRE(pairs);
    REQUIRE(pairs->values.size() >= wanted);
    CHECK(pairs->missing == 0);
    std::vector<Complex> expected = find_all(dense, pairs->shift);
    expected.resize(static_cast<std::size_t>(pairs->values.size()));
    for (Eigen::Index i = 0; i < pairs->values.size(); ++i) {
        INFO("eigenvalue " << i);
        const Complex lambda = pairs->values[i];
        // Some are as far from the shift as others.
        const auto nearest = std::min_element(expected.begin(), expected.end(), [&](Complex a, Complex b) {
            return std::abs(a - lambda) < std::abs(b - lambda);
        });
        CHECK(std::abs(lambda - *nearest) < 1e-9 * std::abs(lambda));
        expected.erase(nearest);
        CHECK(pairs->residuals[i] < 1e-8);
        const Eigen::VectorXcd x = pairs->vectors.col(i);
        const Eigen::VectorXcd Kx = dense.K * x;
        CHECK((Kx + lambda * (dense.D * x) + lambda * lambda * (dense.M * x)).norm() <
              1e-8 * (dense.K.norm() * x.norm()));
    }
}

Eigen::VectorXd make_squares(Eigen::Index size) {
    return Eigen::VectorXd::LinSpaced(size, 1.0, static_cast<double>(size)).array().square();
}

}  // namespace

TEST_CASE("eigenvalues of quadratic problems are those of a dense solver", "[linear]") {
    SECTION("damped") { check_nearest(make_problem(make_squares(40), 0.02, 0.0, 0.0), 6); }
    SECTION("damped so much that some do not swing") {
        check_nearest(make_problem(make_squares(40), 1.0, 0.0, 0.0), 6);
    }
    SECTION("gyroscopic") { check_nearest(make_problem(make_squares(40), 0.0, 0.0, 0.5), 6); }
    SECTION("circulatory, which flutters") {
        check_nearest(make_problem(make_squares(40), 0.0, 5.0, 0.0), 6);
    }
    SECTION("all together") { check_nearest(make_problem(make_squares(40), 0.01, 5.0, 0.5), 8); }
    SECTION("unstable: a negative ω²") {
        Eigen::VectorXd squares = make_squares(30);
        squares[3] = -4.0;
        check_nearest(make_problem(squares, 0.02, 0.1, 0.1), 5);
    }
}

TEST_CASE("copies of a multiple eigenvalue are counted and found", "[linear]") {
    Eigen::VectorXd squares = make_squares(40);
    squares.segment(1, 5).setConstant(4.0);
    const DenseProblem dense = make_problem(squares, 0.0, 0.0, 0.0);
    const QuadraticProblem problem = dense.sparse();
    const auto pairs = find_nearest_pairs(problem, {.wanted = 6});
    REQUIRE(pairs);
    CHECK(pairs->missing == 0);
    REQUIRE(pairs->values.size() == 6);
    for (int i = 1; i < 6; ++i) CHECK(std::abs(pairs->values[i] - Complex(0.0, 2.0)) < 1e-9);
    // Of real and imaginary parts as one real matrix: each of the complex one's twice.
    const Eigen::MatrixXcd copies = pairs->vectors.middleCols(1, 5);
    Eigen::MatrixXd parts(2 * copies.rows(), 2 * copies.cols());
    parts << copies.real(), -copies.imag(), copies.imag(), copies.real();
    CHECK(find_singular_values(parts).values[9] > 1e-6 * copies.norm());
}

TEST_CASE("what moves without inertia has no eigenvalue, or decays by damping alone", "[linear]") {
    DenseProblem dense = make_problem(make_squares(30), 0.01, 0.0, 0.2);
    dense.M.diagonal().tail(12).setZero();
    SECTION("damped") { check_nearest(dense, 6); }
    SECTION("undamped") {
        dense.D.setZero();
        check_nearest(dense, 6);
    }
    SECTION("and if nothing has any, there is nothing to find") {
        dense.M.setZero();
        CHECK_FALSE(find_nearest_pairs(dense.sparse(), {.wanted = 3}));
    }
}

TEST_CASE("rigid motions are found by a shift", "[linear]") {
    Eigen::VectorXd squares = make_squares(30);
    squares.head(3).setZero();
    const DenseProblem dense = make_problem(squares, 0.0, 0.0, 0.0);
    const auto pairs = find_nearest_pairs(dense.sparse(), {.wanted = 8});
    REQUIRE(pairs);
    CHECK(pairs->shift > 0.0);
    std::vector<double> swinging;
    for (const Complex& lambda : pairs->values) {
        if (std::abs(lambda) < 1e-5) continue;
        swinging.push_back(lambda.imag());
    }
    std::sort(swinging.begin(), swinging.end());
    REQUIRE(swinging.size() >= 2);
    CHECK(swinging[0] == Approx(4.0).epsilon(1e-9));
    CHECK(swinging[1] == Approx(5.0).epsilon(1e-9));
}

TEST_CASE("the determinant counts the eigenvalues within a circle", "[linear]") {
    const DenseProblem dense = make_problem(make_squares(30), 0.05, 3.0, 0.3);
    const QuadraticProblem problem = dense.sparse();
    for (const double centre : {0.0, 2.0}) {
        const std::vector<Complex> all = find_all(dense, centre);
        const double radius = 0.5 * (std::abs(all[4] - centre) + std::abs(all[5] - centre));
        std::int64_t within = 0;
        for (int i = 0; i < 5; ++i) within += all[i].imag() > 0.0 ? 2 : 1;
        CHECK(count_more_within(problem, centre, radius, {}) == within);
        Eigen::VectorXcd known = Eigen::VectorXcd::Map(all.data(), 4);
        CHECK(count_more_within(problem, centre, radius, known) == (all[4].imag() > 0.0 ? 2 : 1));
        known = Eigen::VectorXcd::Map(all.data(), 6);
        CHECK(count_more_within(problem, centre, radius, known) == 0);
    }
}

namespace {

// Stiffness of some rank that relaxes in 1/0.7 and in 1/5, and a slow one.
std::vector<Eigen::MatrixXd> make_relaxing(Eigen::Index size, double part) {
    std::mt19937_64 generator(5);
    std::vector<Eigen::MatrixXd> list;
    for (const Eigen::Index rank : {size, size / 3, size / 2}) {
        const Eigen::MatrixXd B = make_random_matrix(generator, size, rank);
        list.push_back(part * B * B.transpose());
    }
    return list;
}

constexpr std::array<double, 3> relaxation_times{1.0 / 0.7, 0.2, 300.0};

QuadraticProblem with_relaxing(const DenseProblem& dense, const std::vector<Eigen::MatrixXd>& relaxing) {
    QuadraticProblem problem = dense.sparse();
    for (std::size_t i = 0; i < relaxing.size(); ++i)
        problem.relaxing.push_back({relaxation_times[i], list_values(relaxing[i])});
    return problem;
}

// All eigenvalues with Im λ ≥ 0 that do not creep, of unknowns x, x′ and the strains w of dashpots, τ w′ = x
// − w.
std::vector<Complex> find_all_relaxing(const DenseProblem& dense,
                                       const std::vector<Eigen::MatrixXd>& relaxing,
                                       double shift) {
    const Eigen::Index n = dense.size();
    const auto count = static_cast<Eigen::Index>(relaxing.size());
    Eigen::MatrixXd A = Eigen::MatrixXd::Zero((2 + count) * n, (2 + count) * n);
    A.block(0, n, n, n).setIdentity();
    A.block(n, 0, n, n) = -dense.K;
    A.block(n, n, n, n) = -dense.D;
    for (Eigen::Index i = 0; i < count; ++i) {
        const double time = relaxation_times[static_cast<std::size_t>(i)];
        A.block(n, 0, n, n) -= relaxing[static_cast<std::size_t>(i)];
        A.block(n, (2 + i) * n, n, n) = relaxing[static_cast<std::size_t>(i)];
        A.block((2 + i) * n, 0, n, n) = Eigen::MatrixXd::Identity(n, n) / time;
        A.block((2 + i) * n, (2 + i) * n, n, n) = -Eigen::MatrixXd::Identity(n, n) / time;
    }
    std::vector<Complex> kept;
    for (const Complex& lambda : find_eigenvalues(A)) {
        if (lambda.imag() >= 0.0 && !creeps(lambda)) kept.push_back(lambda);
    }
    std::sort(kept.begin(), kept.end(), [&](Complex a, Complex b) {
        return std::abs(a - shift) < std::abs(b - shift);
    });
    return kept;
}

}  // namespace

TEST_CASE("what relaxes adds stiffness and damping, and what creeps is left out", "[linear]") {
    for (const double part : {0.01, 0.1, 3.0}) {
        for (const double circulation : {0.0, 1.0}) {
            INFO(part << " " << circulation);
            const DenseProblem dense = make_problem(make_squares(24), 0.0, circulation, 0.1);
            const std::vector<Eigen::MatrixXd> relaxing = make_relaxing(24, part);
            const QuadraticProblem problem = with_relaxing(dense, relaxing);
            const auto pairs = find_nearest_pairs(problem, {.wanted = 6, .left = true});
            REQUIRE(pairs);
            CHECK(pairs->shift > 0.0);
            CHECK(pairs->missing == 0);
            REQUIRE(pairs->values.size() >= 6);
            const std::vector<Complex> all = find_all_relaxing(dense, relaxing, pairs->shift);
            for (Eigen::Index i = 0; i < pairs->values.size(); ++i) {
                const Complex lambda = pairs->values[i];
                CHECK(std::abs(lambda - all[static_cast<std::size_t>(i)]) < 1e-8 * std::abs(lambda));
                const std::vector<Complex> values = problem.at(lambda);
                const Eigen::MatrixXcd T = Eigen::MatrixXcd::Map(values.data(), 24, 24);
                CHECK((T * pairs->vectors.col(i)).norm() < 1e-8 * T.norm() * pairs->vectors.col(i).norm());
                CHECK((T.transpose() * pairs->left.col(i)).norm() <
                      1e-7 * T.norm() * pairs->left.col(i).norm());
            }
        }
    }
}

TEST_CASE("the determinant counts what does not creep where something relaxes", "[linear]") {
    const DenseProblem dense = make_problem(make_squares(24), 0.0, 0.0, 0.1);
    const std::vector<Eigen::MatrixXd> relaxing = make_relaxing(24, 0.1);
    const QuadraticProblem problem = with_relaxing(dense, relaxing);
    for (const double centre : {0.5, 2.0}) {
        const std::vector<Complex> all = find_all_relaxing(dense, relaxing, centre);
        const double radius = 0.5 * (std::abs(all[4] - centre) + std::abs(all[5] - centre));
        CHECK(count_more_within(problem, centre, radius, {}) == 10);
        const Eigen::VectorXcd known = Eigen::VectorXcd::Map(all.data(), 4);
        CHECK(count_more_within(problem, centre, radius, known) == 2);
    }
}

TEST_CASE("complex systems are solved, transposed too, and their determinants have directions", "[linear]") {
    const DenseProblem dense = make_problem(make_squares(12), 0.05, 3.0, 0.3);
    const Complex lambda(0.3, 2.0);
    const std::vector<Complex> values = dense.sparse().at(lambda);
    const Eigen::MatrixXcd A = Eigen::MatrixXcd::Map(values.data(), 12, 12);
    CHECK((A - (dense.K + lambda * dense.D + lambda * lambda * dense.M)).norm() < 1e-12 * A.norm());
    ComplexSolver solver(dense.pattern);
    REQUIRE(solver.factorize(values));
    const Eigen::VectorXcd b = Eigen::VectorXcd::LinSpaced(12, Complex(1.0, 2.0), Complex(-3.0, 1.0));
    Eigen::VectorXcd x = b;
    solver.solve(x);
    CHECK((A * x - b).norm() < 1e-12 * b.norm());
    x = b;
    solver.solve_transposed(x);
    CHECK((A.transpose() * x - b).norm() < 1e-12 * b.norm());
    const Complex determinant = A.determinant();
    CHECK(std::abs(solver.determinant_direction() - determinant / std::abs(determinant)) < 1e-10);
    CHECK_FALSE(solver.factorize(std::vector<Complex>(values.size(), 0.0)));
}

TEST_CASE("directions of determinants know how a sparse matrix was permuted", "[linear]") {
    // Arrows, which are eliminated from their ends.
    for (std::int64_t size = 2; size < 8; ++size) {
        SparsePattern pattern;
        std::vector<std::int64_t> rows(static_cast<std::size_t>(size));
        std::iota(rows.begin(), rows.end(), 0);
        pattern.add_columns(1, rows);
        for (std::int64_t i = 1; i < size; ++i) pattern.add_columns(1, std::vector<std::int64_t>{0, i});
        std::vector<Complex> values;
        Eigen::MatrixXcd A = Eigen::MatrixXcd::Zero(size, size);
        pattern.visit_entries([&](std::int64_t row, std::int64_t column, std::int64_t) {
            const auto place = static_cast<double>(3 * row + column);
            values.push_back(row == column ? Complex(5.0, place) : Complex(1.0, 0.1 * place));
            A(row, column) = values.back();
        });
        ComplexSolver solver(pattern);
        REQUIRE(solver.factorize(values));
        const Complex determinant = A.determinant();
        CHECK(std::abs(solver.determinant_direction() - determinant / std::abs(determinant)) < 1e-10);
    }
}

TEST_CASE("right vectors of the transposed problem are left vectors", "[linear]") {
    const DenseProblem dense = make_problem(make_squares(30), 0.01, 3.0, 0.3);
    const QuadraticProblem problem = dense.sparse();
    const auto pairs = find_nearest_pairs(problem.transposed(), {.wanted = 4});
    REQUIRE(pairs);
    for (Eigen::Index i = 0; i < 4; ++i) {
        const Complex lambda = pairs->values[i];
        const Eigen::MatrixXcd Q = dense.K + lambda * dense.D + lambda * lambda * dense.M;
        CHECK((pairs->vectors.col(i).transpose() * Q).norm() <
              1e-8 * Q.norm() * pairs->vectors.col(i).norm());
    }
}

TEST_CASE("left vectors are found by symmetry or by the transposed problem", "[linear]") {
    struct Row {
        double damping, circulation, gyroscopic;
        bool is_known;  // by symmetry
    };
    for (const Row& row : {Row{0.02, 0.0, 0.0, true}, Row{0.0, 0.0, 0.5, true}, Row{0.01, 3.0, 0.3, false}}) {
        const DenseProblem dense =
            make_problem(make_squares(30), row.damping, row.circulation, row.gyroscopic);
        const auto pairs = find_nearest_pairs(dense.sparse(), {.wanted = 4, .left = true});
        REQUIRE(pairs);
        const auto guess = row.gyroscopic > 0.0 ? pairs->vectors.conjugate().eval() : pairs->vectors;
        CHECK((pairs->left == guess) == row.is_known);
        for (Eigen::Index i = 0; i < 4; ++i) {
            const Complex lambda = pairs->values[i];
            const Eigen::MatrixXcd Q = dense.K + lambda * dense.D + lambda * lambda * dense.M;
            CHECK((pairs->left.col(i).transpose() * Q).norm() < 1e-7 * Q.norm() * pairs->left.col(i).norm());
        }
    }
}
