#include "linear/suite_sparse/klu_solver.hpp"

#include <klu.h>

#include <cassert>

#include "linear/suite_sparse/suite_sparse.hpp"

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

KluSolver::KluSolver(const SparsePattern& pattern)
    : handles_(std::make_unique<Handles>()), columns_(pattern) {
    klu_l_defaults(&handles_->common);
    if (pattern.size() == 0) return;
    handles_->symbolic = klu_l_analyze(pattern.size(),
                                       as_suite_sparse(columns_.column_starts),
                                       as_suite_sparse(columns_.rows),
                                       &handles_->common);
    // A structurally singular matrix is reported when it is factorized.
    if (!handles_->symbolic && handles_->common.status == KLU_OUT_OF_MEMORY) {
        throw_no_memory_to_order();
    }
}

KluSolver::~KluSolver() = default;

Factorization KluSolver::factorize(const std::vector<double>& values) {
    if (columns_.size() == 0) return {};
    klu_l_common& common = handles_->common;
    if (!handles_->symbolic) return {false, -1};
    klu_l_free_numeric(&handles_->numeric, &common);
    handles_->numeric = klu_l_factor(as_suite_sparse(columns_.column_starts),
                                     as_suite_sparse(columns_.rows),
                                     as_suite_sparse(values),
                                     handles_->symbolic,
                                     &common);
    if (common.status == KLU_OUT_OF_MEMORY) {
        throw_no_memory_to_factorize();
    }
    if (!handles_->numeric || common.status == KLU_SINGULAR) return {false, common.singular_col};
    return {};
}

void KluSolver::solve(Eigen::VectorXd& right_hand_side) {
    if (columns_.size() == 0) return;
    assert(handles_->numeric && right_hand_side.size() == columns_.size());
    klu_l_solve(
        handles_->symbolic, handles_->numeric, columns_.size(), 1, right_hand_side.data(), &handles_->common);
}

double KluSolver::estimate_flops_per_entry() const {
    const klu_l_symbolic* symbolic = handles_->symbolic;
    if (!symbolic || symbolic->lnz <= 0.0 || symbolic->est_flops < 0.0) return 0.0;
    return symbolic->est_flops / symbolic->lnz;
}

}  // namespace gxrod
