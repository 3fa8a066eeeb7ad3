#include "solvers/path/bordered_solve.hpp"

#include "assembly/sample_model.hpp"
#include "solvers/sparse_samples.hpp"
#include "tools/catch.hpp"
#include "tools/dense_algebra.hpp"
#include "tools/random_values.hpp"

using namespace gxrod;
using namespace gxrod::tools;

namespace {

// A stiffness whose lowest eigenvalue is `lowest`, and its vector.
struct Soft {
    SparsePattern pattern = make_net_pattern(2, 4);
    std::vector<double> values = make_stiffness_values(pattern, 5);
    Eigen::MatrixXd dense;
};

Soft make_soft(double lowest) {
    Soft soft;
    soft.dense = make_dense(soft.pattern, soft.values);
    const double shift = find_symmetric_eigenvalues(soft.dense)[0] - lowest;
    for (std::int64_t i = 0; i < soft.pattern.size(); ++i)
        soft.values[static_cast<std::size_t>(soft.pattern.slot(i, i))] -= shift;
    soft.dense = make_dense(soft.pattern, soft.values);
    return soft;
}

// The largest error of a bordered system's solution, relative to it.
double find_error(double lowest, bool refined) {
    const Soft soft = make_soft(lowest);
    RandomValues random(3);
    const Eigen::Index n = soft.pattern.size();
    const auto fill = [&](Eigen::MatrixXd matrix) {
        for (double& entry : matrix.reshaped()) entry = random.number(-1.0, 1.0);
        return matrix;
    };
    const Borders borders{
        fill(Eigen::MatrixXd(n, 2)), fill(Eigen::MatrixXd(n, 2)), fill(Eigen::MatrixXd(2, 2))};
    Eigen::MatrixXd whole(n + 2, n + 2);
    whole << soft.dense, borders.columns, borders.rows.transpose(), borders.corner;
    const Eigen::VectorXd expected = fill(Eigen::MatrixXd(n + 2, 1));
    const Eigen::VectorXd right = whole * expected;
    const auto solver = make_linear_solver(LinearSolverKind::chains, soft.pattern);
    REQUIRE(solver->factorize(soft.values).regular);
    const BorderedSolve bordered(*solver, soft.pattern, soft.values, borders);
    const BorderedVector given{right.head(n), right.tail(2)};
    const BorderedVector solved = refined ? bordered.solve_refined(given) : bordered.solve(given);
    Eigen::VectorXd error(n + 2);
    error << solved.x, solved.y;
    return (error - expected).lpNorm<Eigen::Infinity>();
}

}  // namespace

TEST_CASE("a bordered system is solved with the factors of its matrix", "[solvers]") {
    CHECK(find_error(0.5, false) < 1e-12);
    CHECK(find_error(0.5, true) < 1e-12);
}

TEST_CASE("refinement returns the digits of a bordered system whose matrix is nearly singular", "[solvers]") {
    CHECK(find_error(1e-8, false) > 1e-10);
    CHECK(find_error(1e-8, true) < 1e-11);
}
