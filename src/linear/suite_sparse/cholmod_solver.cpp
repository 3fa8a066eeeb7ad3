#include "linear/suite_sparse/cholmod_solver.hpp"

#include <cholmod.h>

#include <cassert>

#include "linear/suite_sparse/suite_sparse.hpp"
#include "linear/symmetric_part.hpp"

namespace gxrod {

struct CholmodSolver::Handles {
    cholmod_common common{};
    SymmetricPart part;
    std::vector<double> values;  // of the lower triangle
    cholmod_sparse matrix{};     // a view of `part` and `values`
    cholmod_factor* factor = nullptr;
    cholmod_dense* solution = nullptr;
    cholmod_dense* work[2] = {nullptr, nullptr};

    explicit Handles(const SparsePattern& pattern) : part(pattern) {
        cholmod_l_start(&common);
        common.print = 0;
        common.supernodal = CHOLMOD_SIMPLICIAL;
        common.nmethods = 1;
        common.method[0].ordering = CHOLMOD_AMD;
        view();
    }
    ~Handles() {
        cholmod_l_free_dense(&work[0], &common);
        cholmod_l_free_dense(&work[1], &common);
        cholmod_l_free_dense(&solution, &common);
        cholmod_l_free_factor(&factor, &common);
        cholmod_l_finish(&common);
    }
    Handles(const Handles&) = delete;
    Handles& operator=(const Handles&) = delete;

    bool is_out_of_memory() const { return common.status == CHOLMOD_OUT_OF_MEMORY; }
    // Makes `matrix` refer to the values where they are now.
    void view() {
        const CompressedColumns& lower = part.pattern();
        values.resize(static_cast<std::size_t>(lower.nonzeros()));
        matrix.nrow = matrix.ncol = static_cast<std::size_t>(lower.size());
        matrix.nzmax = values.size();
        matrix.p = as_suite_sparse(lower.column_starts);
        matrix.i = as_suite_sparse(lower.rows);
        matrix.x = values.data();
        matrix.stype = -1;
        matrix.itype = CHOLMOD_LONG;
        matrix.xtype = CHOLMOD_REAL;
        matrix.dtype = CHOLMOD_DOUBLE;
        matrix.sorted = matrix.packed = 1;
    }
    void solve(Eigen::VectorXd& right_hand_side);
};

namespace {

cholmod_dense view_of(Eigen::VectorXd& vector) {
    cholmod_dense dense{};
    dense.nrow = dense.nzmax = dense.d = static_cast<std::size_t>(vector.size());
    dense.ncol = 1;
    dense.x = vector.data();
    dense.xtype = CHOLMOD_REAL;
    dense.dtype = CHOLMOD_DOUBLE;
    return dense;
}

// Of the D of L D Lᵀ, whose entries stand first in the columns of a simplicial factor.
std::int64_t count_negative(const cholmod_factor& factor) {
    const auto* starts = static_cast<const SuiteSparse_long*>(factor.p);
    const auto* entries = static_cast<const double*>(factor.x);
    std::int64_t count = 0;
    for (std::size_t column = 0; column < factor.n; ++column) count += entries[starts[column]] < 0.0;
    return count;
}

}  // namespace

// Replaces the right-hand side by the solution with the factors, as they are.
void CholmodSolver::Handles::solve(Eigen::VectorXd& right_hand_side) {
    cholmod_dense b = view_of(right_hand_side);
    cholmod_l_solve2(CHOLMOD_A, factor, &b, nullptr, &solution, nullptr, &work[0], &work[1], &common);
    if (is_out_of_memory()) throw_no_memory_to_factorize();
    right_hand_side =
        Eigen::Map<const Eigen::VectorXd>(static_cast<const double*>(solution->x), right_hand_side.size());
}

CholmodSolver::CholmodSolver(const SparsePattern& pattern)
    : handles_(std::make_unique<Handles>(pattern)), size_(pattern.size()) {
    if (size_ == 0) return;
    handles_->factor = cholmod_l_analyze(&handles_->matrix, &handles_->common);
    if (handles_->is_out_of_memory()) throw_no_memory_to_order();
    assert(handles_->factor);
}

CholmodSolver::~CholmodSolver() = default;

Factorization CholmodSolver::factorize(const std::vector<double>& values) {
    if (size_ == 0) return {};
    handles_->part.compute(values, handles_->values);
    cholmod_l_factorize(&handles_->matrix, handles_->factor, &handles_->common);
    if (handles_->is_out_of_memory()) throw_no_memory_to_factorize();
    const std::size_t failed = handles_->factor->minor;
    if (failed == handles_->factor->n) return {.negative_pivots = count_negative(*handles_->factor)};
    return {false, static_cast<const SuiteSparse_long*>(handles_->factor->Perm)[failed]};
}

void CholmodSolver::solve(Eigen::VectorXd& right_hand_side) {
    if (size_ == 0) return;
    assert(right_hand_side.size() == size_);
    Eigen::VectorXd remainder = right_hand_side;
    handles_->solve(right_hand_side);
    // Without pivoting the factors may hold large numbers; one correction wins the digits back.
    double minus_one[2] = {-1.0, 0.0};
    double one[2] = {1.0, 0.0};
    cholmod_dense x = view_of(right_hand_side);
    cholmod_dense r = view_of(remainder);
    cholmod_l_sdmult(&handles_->matrix, 0, minus_one, one, &x, &r, &handles_->common);
    handles_->solve(remainder);
    right_hand_side += remainder;
}

}  // namespace gxrod
