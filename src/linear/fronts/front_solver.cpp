#include "linear/fronts/front_solver.hpp"

namespace gxrod {
namespace {

FrontLayout lay_out(const SparsePattern& pattern) {
    const BlockPartition partition(pattern);
    return {pattern, partition, FrontOrder(partition)};
}

}  // namespace

FrontSolver::FrontSolver(const SparsePattern& pattern)
    : layout_(lay_out(pattern)),
      kernels_(find_front_kernels(find_instruction_set())),
      factors_(static_cast<std::size_t>(layout_.factors)),
      solution_(layout_.unknowns.size()),
      work_(static_cast<std::size_t>(layout_.most_rows)) {
    for (std::size_t i = 0; i < stacks_.size(); ++i)
        stacks_[i].resize(static_cast<std::size_t>(layout_.stacks[i]));
}

Fronts FrontSolver::fronts() const {
    return {layout_.fronts.data(),
            static_cast<std::int64_t>(layout_.fronts.size()),
            layout_.runs.data(),
            layout_.copies.data(),
            layout_.children.data()};
}

double FrontSolver::estimate_flops() const {
    double flops = 0.0;
    for (const Front& front : layout_.fronts) {
        for (std::int32_t pivot = 0; pivot < front.pivots; ++pivot) {
            const double behind = front.rows - pivot - 1;
            flops += 2.0 * behind * behind;
        }
    }
    return flops;
}

bool FrontSolver::factorize(const std::vector<double>& values) {
    double* const stacks[2] = {stacks_[0].data(), stacks_[1].data()};
    const Fronts all = fronts();
    negative_pivots_ = 0;
    for (std::int64_t front = 0; front < all.count; ++front) {
        if (!kernels_.eliminate(all, front, values.data(), factors_.data(), stacks, negative_pivots_))
            return false;
    }
    return true;
}

void FrontSolver::solve(Eigen::VectorXd& right_hand_side) {
    for (std::size_t i = 0; i < layout_.unknowns.size(); ++i)
        solution_[i] = right_hand_side[layout_.unknowns[i]];
    const Fronts all = fronts();
    for (std::int64_t front = 0; front < all.count; ++front)
        kernels_.go_forward(all, front, factors_.data(), solution_.data(), work_.data());
    for (std::int64_t front = all.count - 1; front >= 0; --front)
        kernels_.go_backward(all, front, factors_.data(), solution_.data(), work_.data());
    for (std::size_t i = 0; i < layout_.unknowns.size(); ++i)
        right_hand_side[layout_.unknowns[i]] = solution_[i];
}

}  // namespace gxrod
