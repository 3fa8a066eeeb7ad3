// By Sylvester's law of inertia a symmetric matrix has as many negative pivots as negative eigenvalues, in
// whatever order it is eliminated.

#include "assembly/sample_model.hpp"
#include "solvers/sparse_samples.hpp"
#include "tools/catch.hpp"
#include "tools/dense_algebra.hpp"
#include "tools/random_values.hpp"

using namespace gxrod;
using namespace gxrod::tools;

namespace {

// Subtracts shift × identity.
std::vector<double> shift(const SparsePattern& pattern, std::vector<double> values, double by) {
    for (std::int64_t i = 0; i < pattern.size(); ++i) values[pattern.slot(i, i)] -= by;
    return values;
}

}  // namespace

TEST_CASE("negative pivots count negative eigenvalues of rods and nets", "[solvers]") {
    for (const auto& [width, height] : {std::pair{1, 2}, {1, 9}, {2, 2}, {3, 4}, {5, 6}}) {
        const SparsePattern pattern = make_net_pattern(width, height);
        const std::vector<double> stiffness = make_stiffness_values(pattern, 3);
        const Eigen::VectorXd eigenvalues = find_symmetric_eigenvalues(make_dense(pattern, stiffness));
        const std::int64_t size = eigenvalues.size();
        for (const std::int64_t below :
             {std::int64_t{0}, std::int64_t{1}, std::int64_t{2}, size / 2, size - 1, size}) {
            CAPTURE(width, height, below);
            const double low = below == 0 ? eigenvalues[0] - 1.0 : eigenvalues[below - 1];
            const double high = below == size ? eigenvalues[size - 1] + 1.0 : eigenvalues[below];
            const std::vector<double> values = shift(pattern, stiffness, 0.5 * (low + high));
            const Factorization factorization =
                make_linear_solver(LinearSolverKind::chains, pattern)->factorize(values);
            REQUIRE(factorization.regular);
            CHECK(factorization.negative_pivots == below);
            for (const int threads : {2, 3}) {
                const ThreadTeam team(threads);
                const auto solver = make_linear_solver(LinearSolverKind::chains, pattern, team);
                CHECK(solver->factorize(values).negative_pivots == below);
            }
        }
    }
}

TEST_CASE("negative pivots of an unsymmetric matrix have the parity of its determinant", "[solvers]") {
    int negative = 0;
    for (unsigned seed = 1; seed <= 20; ++seed) {
        const SparsePattern pattern = make_net_pattern(2, 3);
        std::vector<double> values = make_stiffness_values(pattern, seed);
        const Eigen::VectorXd eigenvalues = find_symmetric_eigenvalues(make_dense(pattern, values));
        values = shift(pattern, values, 0.5 * (eigenvalues[seed] + eigenvalues[seed + 1]));
        RandomValues random(seed);
        for (double& value : values) value *= random.number(0.9, 1.1);
        const double determinant = find_determinant(make_dense(pattern, values));
        const Factorization factorization =
            make_linear_solver(LinearSolverKind::chains, pattern)->factorize(values);
        REQUIRE(factorization.regular);
        CHECK((factorization.negative_pivots % 2 == 1) == (determinant < 0.0));
        negative += determinant < 0.0 ? 1 : 0;
    }
    CHECK(negative > 0);
    CHECK(negative < 20);
}

TEST_CASE("solvers that exchange rows do not know the number of negative pivots", "[solvers]") {
    const SparsePattern pattern = make_net_pattern(2, 3);
    const std::vector<double> values = make_stiffness_values(pattern, 1);
    for (const LinearSolverKind kind : {LinearSolverKind::klu, LinearSolverKind::umfpack})
        CHECK(make_linear_solver(kind, pattern)->factorize(values).negative_pivots == -1);
}
