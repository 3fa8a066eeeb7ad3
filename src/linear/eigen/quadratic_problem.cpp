#include "linear/eigen/quadratic_problem.hpp"

namespace gxrod {

namespace {

template <class Number>
std::vector<Number> add_up(const QuadraticProblem& problem, Number lambda) {
    std::vector<Number> values(problem.K.size());
    for (std::size_t i = 0; i < values.size(); ++i)
        values[i] = problem.K[i] + lambda * (problem.D[i] + lambda * problem.M[i]);
    return values;
}

}  // namespace

std::vector<double> QuadraticProblem::at(double lambda) const { return add_up(*this, lambda); }

std::vector<std::complex<double>> QuadraticProblem::at(std::complex<double> lambda) const {
    return add_up(*this, lambda);
}

QuadraticProblem QuadraticProblem::transposed() const {
    QuadraticProblem other = *this;
    pattern->visit_entries([&](std::int64_t row, std::int64_t column, std::int64_t slot) {
        const std::int64_t mirrored = pattern->slot(column, row);
        other.K[static_cast<std::size_t>(slot)] = K[static_cast<std::size_t>(mirrored)];
        other.D[static_cast<std::size_t>(slot)] = D[static_cast<std::size_t>(mirrored)];
        other.M[static_cast<std::size_t>(slot)] = M[static_cast<std::size_t>(mirrored)];
    });
    return other;
}

}  // namespace gxrod
