#include "linear/suite_sparse/umfpack_solver.hpp"

#include <umfpack.h>

#include <array>
#include <cassert>

#include "linear/suite_sparse/suite_sparse.hpp"

namespace gxrod {

struct UmfpackSolver::Handles {
    std::array<double, UMFPACK_CONTROL> control{};
    void* symbolic = nullptr;
    void* numeric = nullptr;
    std::vector<std::int64_t> index_work;
    Eigen::VectorXd work, solution;

    ~Handles() {
        umfpack_dl_free_numeric(&numeric);
        umfpack_dl_free_symbolic(&symbolic);
    }
    SuiteSparse_long factorize(const CompressedColumns& columns, const std::vector<double>& values) {
        umfpack_dl_free_numeric(&numeric);
        return umfpack_dl_numeric(as_suite_sparse(columns.column_starts),
                                  as_suite_sparse(columns.rows),
                                  as_suite_sparse(values),
                                  symbolic,
                                  &numeric,
                                  control.data(),
                                  nullptr);
    }
};

namespace {

// The column of the first zero on the diagonal of U; −1 if there is none.
std::int64_t find_zero_pivot(void* numeric, std::int64_t size) {
    std::vector<double> pivots(static_cast<std::size_t>(size));
    std::vector<std::int64_t> columns(static_cast<std::size_t>(size));
    SuiteSparse_long reciprocal = 0;
    umfpack_dl_get_numeric(nullptr,
                           nullptr,
                           nullptr,
                           nullptr,
                           nullptr,
                           nullptr,
                           nullptr,
                           as_suite_sparse(columns),
                           pivots.data(),
                           &reciprocal,
                           nullptr,
                           numeric);
    for (std::size_t k = 0; k < pivots.size(); ++k) {
        if (pivots[k] == 0.0) return columns[k];
    }
    return -1;
}

}  // namespace

UmfpackSolver::UmfpackSolver(const SparsePattern& pattern)
    : handles_(std::make_unique<Handles>()), columns_(pattern) {
    umfpack_dl_defaults(handles_->control.data());
    // Newton's iterations refine; and the values may have changed when a right-hand side comes.
    handles_->control[UMFPACK_IRSTEP] = 0.0;
    // A structure's pattern is symmetric and has its diagonal, which UMFPACK, left to itself, does not use:
    // it then needs several times the fill, and lost all digits on a net of 100 × 100 members.
    handles_->control[UMFPACK_STRATEGY] = UMFPACK_STRATEGY_SYMMETRIC;
    if (pattern.size() == 0) return;
    // Without values: the order of elimination depends on the pattern alone.
    const SuiteSparse_long status = umfpack_dl_symbolic(pattern.size(),
                                                        pattern.size(),
                                                        as_suite_sparse(columns_.column_starts),
                                                        as_suite_sparse(columns_.rows),
                                                        nullptr,
                                                        &handles_->symbolic,
                                                        handles_->control.data(),
                                                        nullptr);
    if (status == UMFPACK_ERROR_out_of_memory) throw_no_memory_to_order();
    assert(status == UMFPACK_OK);
    handles_->index_work.resize(static_cast<std::size_t>(pattern.size()));
    handles_->work.resize(pattern.size());
}

UmfpackSolver::~UmfpackSolver() = default;

Factorization UmfpackSolver::factorize(const std::vector<double>& values) {
    if (columns_.size() == 0) return {};
    const SuiteSparse_long status = handles_->factorize(columns_, values);
    if (status == UMFPACK_ERROR_out_of_memory) throw_no_memory_to_factorize();
    if (status == UMFPACK_OK) return {};
    return {false, handles_->numeric ? find_zero_pivot(handles_->numeric, columns_.size()) : -1};
}

void UmfpackSolver::solve(Eigen::VectorXd& right_hand_side) {
    if (columns_.size() == 0) return;
    assert(handles_->numeric && right_hand_side.size() == columns_.size());
    handles_->solution.resize(right_hand_side.size());
    umfpack_dl_wsolve(UMFPACK_A,
                      nullptr,
                      nullptr,
                      nullptr,
                      handles_->solution.data(),
                      right_hand_side.data(),
                      handles_->numeric,
                      handles_->control.data(),
                      nullptr,
                      as_suite_sparse(handles_->index_work),
                      handles_->work.data());
    right_hand_side = handles_->solution;
}

}  // namespace gxrod
