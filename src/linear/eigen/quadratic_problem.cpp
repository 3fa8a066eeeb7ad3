#include "linear/eigen/quadratic_problem.hpp"

namespace gxrod {

namespace {

template <class Number>
std::vector<Number> add_up(const QuadraticProblem& problem, Number lambda) {
    std::vector<Number> values(problem.K.size());
    for (std::size_t i = 0; i < values.size(); ++i)
        values[i] = problem.K[i] + lambda * (problem.D[i] + lambda * problem.M[i]);
    for (const RelaxingMatrix& one : problem.relaxing) {
        const Number factor = one.factor(lambda);
        for (std::size_t i = 0; i < values.size(); ++i) values[i] += factor * one.values[i];
    }
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
        const auto to = static_cast<std::size_t>(slot);
        const auto from = static_cast<std::size_t>(pattern->slot(column, row));
        other.K[to] = K[from];
        other.D[to] = D[from];
        other.M[to] = M[from];
        for (std::size_t i = 0; i < relaxing.size(); ++i)
            other.relaxing[i].values[to] = relaxing[i].values[from];
    });
    return other;
}

}  // namespace gxrod
