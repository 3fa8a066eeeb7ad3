#include "linear/complex_as_real.hpp"

#include <cmath>

#include "solvers/sparse_samples.hpp"
#include "tools/catch.hpp"

using namespace gxrod;
using namespace gxrod::tools;

TEST_CASE("complex systems are solved as real ones of twice the size", "[linear]") {
    for (const LinearSolverKind kind :
         {LinearSolverKind::chains, LinearSolverKind::klu, LinearSolverKind::umfpack}) {
        for (const int width : {1, 3}) {
            INFO("solver " << static_cast<int>(kind) << ", width " << width);
            const SparsePattern pattern = make_net_pattern(width, 7);
            const std::vector<double> real = make_stiffness_values(pattern, 3);
            const std::vector<double> imaginary = make_stiffness_values(pattern, 4);
            const auto size = static_cast<Eigen::Index>(pattern.size());
            Eigen::VectorXd x(size), y(size);
            Eigen::VectorXcd factors(size);
            for (Eigen::Index i = 0; i < size; ++i) {
                x[i] = std::sin(static_cast<double>(i) + 1.0);
                y[i] = std::cos(3.0 * static_cast<double>(i));
                factors[i] = std::polar(1.0, 0.2 * std::sin(static_cast<double>(i)));
            }
            Eigen::VectorXcd solution(size);
            solution.real() = tools::multiply(pattern, real, x) - tools::multiply(pattern, imaginary, y);
            solution.imag() = tools::multiply(pattern, real, y) + tools::multiply(pattern, imaginary, x);
            ComplexAsReal solver(kind, pattern);
            REQUIRE(solver.factorize(real, imaginary, factors).regular);
            solver.solve(solution);
            CHECK((solution.real() - x).norm() < 1e-10 * x.norm());
            CHECK((solution.imag() - y).norm() < 1e-10 * y.norm());
        }
    }
}

TEST_CASE("a complex system without a solution is reported", "[linear]") {
    const SparsePattern pattern = make_net_pattern(1, 4);
    const std::vector<double> none(static_cast<std::size_t>(pattern.nonzeros()), 0.0);
    ComplexAsReal solver(LinearSolverKind::chains, pattern);
    const Eigen::VectorXcd factors = Eigen::VectorXcd::Ones(static_cast<Eigen::Index>(pattern.size()));
    CHECK_FALSE(solver.factorize(none, none, factors).regular);
}
