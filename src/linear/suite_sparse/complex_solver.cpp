#include "linear/suite_sparse/complex_solver.hpp"

#include <klu.h>

#include <cassert>

#include "linear/suite_sparse/suite_sparse.hpp"

namespace gxrod {

namespace {

// 1 or −1.
int find_sign(const SuiteSparse_long* permutation, std::int64_t size) {
    std::vector<bool> is_seen(static_cast<std::size_t>(size), false);
    int sign = 1;
    for (std::int64_t i = 0; i < size; ++i) {
        for (std::int64_t j = permutation[i]; !is_seen[static_cast<std::size_t>(i)] && j != i;
             j = permutation[j]) {
            is_seen[static_cast<std::size_t>(j)] = true;
            sign = -sign;
        }
        is_seen[static_cast<std::size_t>(i)] = true;
    }
    return sign;
}

}  // namespace

struct ComplexSolver::Handles {
    klu_l_common common{};
    klu_l_symbolic* symbolic = nullptr;
    klu_l_numeric* numeric = nullptr;

    ~Handles() {
        klu_zl_free_numeric(&numeric, &common);
        klu_l_free_symbolic(&symbolic, &common);
    }
};

ComplexSolver::ComplexSolver(const SparsePattern& pattern)
    : handles_(std::make_unique<Handles>()), columns_(pattern) {
    klu_l_defaults(&handles_->common);
    if (columns_.size() == 0) return;
    handles_->symbolic = klu_l_analyze(columns_.size(),
                                       as_suite_sparse(columns_.column_starts),
                                       as_suite_sparse(columns_.rows),
                                       &handles_->common);
    if (!handles_->symbolic && handles_->common.status == KLU_OUT_OF_MEMORY) throw_no_memory_to_order();
}

ComplexSolver::~ComplexSolver() = default;

bool ComplexSolver::factorize(const std::vector<std::complex<double>>& values) {
    if (columns_.size() == 0) return true;
    klu_l_common& common = handles_->common;
    if (!handles_->symbolic) return false;
    klu_zl_free_numeric(&handles_->numeric, &common);
    // Real and imaginary parts alternate, as KLU has them.
    auto* numbers = const_cast<double*>(reinterpret_cast<const double*>(values.data()));
    handles_->numeric = klu_zl_factor(as_suite_sparse(columns_.column_starts),
                                      as_suite_sparse(columns_.rows),
                                      numbers,
                                      handles_->symbolic,
                                      &common);
    if (common.status == KLU_OUT_OF_MEMORY) throw_no_memory_to_factorize();
    return handles_->numeric && common.status != KLU_SINGULAR;
}

void ComplexSolver::solve(Eigen::VectorXcd& right_hand_side) {
    if (columns_.size() == 0) return;
    assert(handles_->numeric && right_hand_side.size() == columns_.size());
    klu_zl_solve(handles_->symbolic,
                 handles_->numeric,
                 columns_.size(),
                 1,
                 reinterpret_cast<double*>(right_hand_side.data()),
                 &handles_->common);
}

void ComplexSolver::solve_transposed(Eigen::VectorXcd& right_hand_side) {
    if (columns_.size() == 0) return;
    assert(handles_->numeric && right_hand_side.size() == columns_.size());
    constexpr int not_conjugated = 0;
    klu_zl_tsolve(handles_->symbolic,
                  handles_->numeric,
                  columns_.size(),
                  1,
                  reinterpret_cast<double*>(right_hand_side.data()),
                  not_conjugated,
                  &handles_->common);
}

std::complex<double> ComplexSolver::determinant_direction() const {
    if (columns_.size() == 0) return 1.0;
    const auto* pivots = static_cast<const std::complex<double>*>(handles_->numeric->Udiag);
    // KLU divides rows by positive numbers, which changes no direction.
    std::complex<double> direction = find_sign(handles_->numeric->Pnum, columns_.size()) *
                                     find_sign(handles_->symbolic->Q, columns_.size());
    for (std::int64_t i = 0; i < columns_.size(); ++i) direction *= pivots[i] / std::abs(pivots[i]);
    return direction / std::abs(direction);
}

}  // namespace gxrod
