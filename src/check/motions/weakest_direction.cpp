#include "check/motions/weakest_direction.hpp"

#include <cmath>

#include "linear/linear_solver.hpp"

namespace gxrod {

namespace {

// Factorizes values + shift × identity, with the first shift of a few that makes it regular.
void factorize_shifted(const SparsePattern& pattern, std::vector<double> values, LinearSolver& solver) {
    double shift = 0.0;
    for (double next = 1e-15; next < 1.0; next *= 100.0) {
        for (std::int64_t j = 0; j < pattern.size(); ++j) values[pattern.slot(j, j)] += next - shift;
        shift = next;
        if (solver.factorize(values).regular) return;
    }
}

// Components of both signs and any size, so that no direction that comes up is orthogonal to it.
Eigen::VectorXd make_start(std::int64_t size) {
    Eigen::VectorXd start(size);
    for (std::int64_t i = 0; i < size; ++i) {
        start[i] = std::sin(1.0 + 0.7 * static_cast<double>(i * i % 1009));
    }
    return start.normalized();
}

}  // namespace

std::optional<WeakestDirection> find_weakest_direction(const ScaledTangent& tangent) {
    constexpr int most_iterations = 30;
    const SparsePattern& pattern = tangent.pattern();
    if (pattern.size() == 0 || !tangent.is_finite()) return std::nullopt;
    const auto solver = make_general_solver(pattern);
    const auto transposed = make_general_solver(pattern);
    factorize_shifted(pattern, tangent.values(), *solver);
    factorize_shifted(pattern, tangent.compute_transpose(), *transposed);
    Eigen::VectorXd x = make_start(pattern.size());
    for (int iteration = 0; iteration < most_iterations; ++iteration) {
        Eigen::VectorXd next = x;
        transposed->solve(next);
        next.normalize();
        solver->solve(next);
        next.normalize();
        if (!next.allFinite()) break;
        const double turned = 1.0 - std::abs(next.dot(x));
        x = next;
        if (turned < 1e-10) break;
    }
    return WeakestDirection{x, tangent.multiply(x).norm()};
}

}  // namespace gxrod
