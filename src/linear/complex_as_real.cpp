#include "linear/complex_as_real.hpp"

namespace gxrod {

ComplexAsReal::ComplexAsReal(LinearSolverKind kind, const SparsePattern& pattern, const ThreadTeam& team)
    : pattern_(&pattern), stacked_(pattern, 2), solver_(make_linear_solver(kind, stacked_.pattern(), team)) {}

Factorization ComplexAsReal::factorize(const std::vector<double>& real,
                                       const std::vector<double>& imaginary,
                                       const Eigen::VectorXcd& factors) {
    factors_ = factors;
    real_.resize(real.size());
    imaginary_.resize(real.size());
    pattern_->visit_entries([&](std::int64_t row, std::int64_t, std::int64_t entry) {
        const auto slot = static_cast<std::size_t>(entry);
        const std::complex<double> value = factors[row] * std::complex<double>(real[slot], imaginary[slot]);
        real_[slot] = value.real();
        imaginary_[slot] = value.imag();
    });
    stacked_.set(0, 0, real_, 1.0, values_);
    stacked_.set(1, 1, real_, 1.0, values_);
    stacked_.set(1, 0, imaginary_, 1.0, values_);
    stacked_.set(0, 1, imaginary_, -1.0, values_);
    return solver_->factorize(values_);
}

void ComplexAsReal::solve(Eigen::VectorXcd& right_hand_side) {
    const Eigen::VectorXcd scaled = factors_.cwiseProduct(right_hand_side);
    stacked_.set(0, scaled.real(), vector_);
    stacked_.set(1, scaled.imag(), vector_);
    solver_->solve(vector_);
    stacked_.get(0, vector_, part_);
    right_hand_side.real() = part_;
    stacked_.get(1, vector_, part_);
    right_hand_side.imag() = part_;
}

}  // namespace gxrod
