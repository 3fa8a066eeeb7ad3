#include "solvers/path/soft_modes.hpp"

#include <algorithm>

#include "solvers/sparse_samples.hpp"
#include "tools/catch.hpp"
#include "tools/dense_algebra.hpp"

using namespace gxrod;
using namespace gxrod::tools;

TEST_CASE("the eigenvalues closest to zero and their vectors are those of a dense solver", "[solvers]") {
    const SparsePattern pattern = make_net_pattern(2, 4);
    std::vector<double> values = make_stiffness_values(pattern, 7);
    Eigen::MatrixXd dense = make_dense(pattern, values);
    const Eigen::VectorXd spectrum = find_symmetric_eigenvalues(dense);
    // Two negative ones.
    const double shift = 0.5 * (spectrum[1] + spectrum[2]);
    for (std::int64_t i = 0; i < pattern.size(); ++i)
        values[static_cast<std::size_t>(pattern.slot(i, i))] -= shift;
    dense = make_dense(pattern, values);
    Eigen::VectorXd weights(pattern.size());
    for (Eigen::Index i = 0; i < weights.size(); ++i) weights[i] = 0.5 + 0.1 * static_cast<double>(i % 7);
    const Eigen::MatrixXd mass = weights.asDiagonal();
    const Eigen::VectorXd all = find_symmetric_eigenvalues(dense, mass);
    std::vector<double> nearest(all.begin(), all.end());
    std::sort(nearest.begin(), nearest.end(), [](double a, double b) { return std::abs(a) < std::abs(b); });
    nearest.resize(3);
    std::sort(nearest.begin(), nearest.end());

    const auto solver = make_linear_solver(LinearSolverKind::chains, pattern);
    REQUIRE(solver->factorize(values).regular);
    const SoftModes modes = find_soft_modes(*solver, pattern, values, weights, 3, true);
    REQUIRE(modes.values.size() == 3);
    for (int i = 0; i < 3; ++i) {
        CHECK(modes.values[i] == Approx(nearest[static_cast<std::size_t>(i)]).epsilon(1e-8));
        const Eigen::VectorXd x = modes.vectors.col(i);
        CHECK(x.dot(mass * x) == Approx(1.0));
        CHECK((dense * x - modes.values[i] * mass * x).norm() < 1e-3 * std::abs(all[all.size() - 1]));
    }
}
