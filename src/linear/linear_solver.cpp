#include "linear/linear_solver.hpp"

#include "linear/chains/chain_solver.hpp"
#include "linear/suite_sparse/klu_solver.hpp"
#include "linear/suite_sparse/umfpack_solver.hpp"

namespace gxrod {

namespace {

// Above so many flops per entry of L, the dense fronts of UMFPACK beat KLU. Time of UMFPACK over that of KLU,
// of a factorization and a solution (SuiteSparse 5.12; reference BLAS, then OpenBLAS 0.3.21 on one core):
//
//   matrix                                      unknowns   flops/entry   time ratio
//   rod, 10 … 1000 elements of order 1           60 … 6000            17   2.1 … 2.9   2.6 … 3.9
//   rod, 10 … 1000 elements of order 4         240 … 24000            39   1.6 … 2.3   1.5 … 2.5
//   net of 10 × 10, 4 elements a member               3834            43   1.6         1.4
//   net of 20 × 20, 1 element a member                2394           156   1.2         0.5
//   net of 40 × 40, 2 elements a member              28314           212   1.1         0.8
//   net of 60 × 60, 1 element a member               21594           445   0.8         0.3
//   lattice of 5 × 5 × 5, 1 element a member           744           184   1.1         0.5
//   lattice of 8 × 8 × 8, 1 element a member          3066           511   0.8         0.2
//   lattice of 10 × 10 × 10, 4 elements              54594           539   0.9         0.4
constexpr double flops_per_entry_for_fronts = 200.0;

std::unique_ptr<LinearSolver> choose_linear_solver(const SparsePattern& pattern, const ThreadTeam& team) {
    auto chains = std::make_unique<ChainSolver>(pattern, team);
    if (chains->works_by_blocks()) return chains;
    chains.reset();
    return make_general_solver(pattern);
}

}  // namespace

std::unique_ptr<LinearSolver> make_general_solver(const SparsePattern& pattern) {
    auto klu = std::make_unique<KluSolver>(pattern);
    if (klu->estimate_flops_per_entry() < flops_per_entry_for_fronts) return klu;
    klu.reset();
    return std::make_unique<UmfpackSolver>(pattern);
}

std::unique_ptr<LinearSolver> make_linear_solver(LinearSolverKind kind,
                                                 const SparsePattern& pattern,
                                                 const ThreadTeam& team) {
    switch (kind) {
        case LinearSolverKind::chains:
            return std::make_unique<ChainSolver>(pattern, team);
        case LinearSolverKind::klu:
            return std::make_unique<KluSolver>(pattern);
        case LinearSolverKind::umfpack:
            return std::make_unique<UmfpackSolver>(pattern);
        case LinearSolverKind::automatic:
            break;
    }
    return choose_linear_solver(pattern, team);
}

}  // namespace gxrod
