#include "solvers/klu_solver.hpp"

#include <klu.h>

#include <cassert>
#include <stdexcept>

namespace gxrod {

struct KluSolver::Handles {
    klu_l_common common{};
    klu_l_symbolic* symbolic = nullptr;
    klu_l_numeric* numeric = nullptr;

    ~Handles() {
        klu_l_free_numeric(&numeric, &common);
        klu_l_free_symbolic(&symbolic, &common);
    }
};

static_assert(sizeof(SuiteSparse_long) == sizeof(std::int64_t));

namespace {

// KLU takes the pattern by pointers to non-const and does not write through them.
SuiteSparse_long* as_klu(const std::vector<std::int64_t>& indices) {
    return reinterpret_cast<SuiteSparse_long*>(const_cast<std::int64_t*>(indices.data()));
}

}  // namespace

KluSolver::KluSolver(const SparsePattern& pattern)
    : handles_(std::make_unique<Handles>()), pattern_(&pattern) {
    klu_l_defaults(&handles_->common);
    if (pattern.size() == 0) return;
    handles_->symbolic =
        klu_l_analyze(pattern.size(), as_klu(pattern.column_starts), as_klu(pattern.rows), &handles_->common);
    // A structurally singular matrix is told apart from a lack of memory when it is factorized.
    if (!handles_->symbolic && handles_->common.status == KLU_OUT_OF_MEMORY) {
        throw std::runtime_error("not enough memory to order the system of equations");
    }
}

KluSolver::~KluSolver() = default;

Factorization KluSolver::factorize(const std::vector<double>& values) {
    if (pattern_->size() == 0) return {};
    klu_l_common& common = handles_->common;
    if (!handles_->symbolic) return {false, -1};
    klu_l_free_numeric(&handles_->numeric, &common);
    handles_->numeric = klu_l_factor(as_klu(pattern_->column_starts),
                                     as_klu(pattern_->rows),
                                     const_cast<double*>(values.data()),
                                     handles_->symbolic,
                                     &common);
    if (common.status == KLU_OUT_OF_MEMORY) {
        throw std::runtime_error("not enough memory to factorize the system of equations");
    }
    if (!handles_->numeric || common.status == KLU_SINGULAR) return {false, common.singular_col};
    return {};
}

void KluSolver::solve(Eigen::VectorXd& right_hand_side) {
    if (pattern_->size() == 0) return;
    assert(handles_->numeric && right_hand_side.size() == pattern_->size());
    klu_l_solve(handles_->symbolic,
                handles_->numeric,
                pattern_->size(),
                1,
                right_hand_side.data(),
                &handles_->common);
}

std::unique_ptr<LinearSolver> make_linear_solver(LinearSolverKind, const SparsePattern& pattern) {
    return std::make_unique<KluSolver>(pattern);
}

}  // namespace gxrod
