#include "solvers/chain_solver.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "solvers/chain_layout.hpp"

namespace gxrod {
namespace {

// What is left of a solution is round-off if its residual is so small against |A| |x| + |b|.
constexpr double round_off = 1e-13;
// So is what has decayed along a chain until numbers have fewer digits.
constexpr double smallest = 1e-290;

bool has_diagonal(const SparsePattern& pattern) {
    std::int64_t found = 0;
    for (std::size_t index = 0; index < pattern.block_count(); ++index) {
        const SparsePattern::Block block = pattern.block(index);
        for (const SparsePattern::RowRun& run : block.runs) {
            const std::int64_t first = std::max(run.first, block.first_column);
            const std::int64_t last = std::min(run.first + run.count, block.first_column + block.columns);
            found += std::max<std::int64_t>(0, last - first);
        }
    }
    return found == pattern.size();
}

}  // namespace

ChainSolver::ChainSolver(const SparsePattern& pattern)
    : pattern_(&pattern), kernels_(find_chain_kernels(find_instruction_set())) {
    // Steps count unknowns in 32 bits; a block has fewer rows and columns than there are unknowns.
    if (pattern.size() > std::numeric_limits<std::int32_t>::max() || !has_diagonal(pattern)) return;
    std::int64_t size = 0;
    {
        const BlockPartition partition(pattern);
        const EliminationOrder order(partition, largest_chain_block);
        if (order.steps.empty()) return;
        ChainLayout layout(pattern, partition, order);
        lay_out_junctions(partition, order, layout);
        runs_ = find_entry_runs(pattern);
        steps_ = std::move(layout.steps);
        couplings_ = std::move(layout.couplings);
        copies_ = std::move(layout.copies);
        size = layout.size;
    }
    blocks_.resize(static_cast<std::size_t>(size));
}

void ChainSolver::lay_out_junctions(const BlockPartition& partition,
                                    const EliminationOrder& order,
                                    const ChainLayout& layout) {
    if (order.kept.empty()) return;
    std::vector<std::int64_t> starts(partition.count(), -1);  // among the unknowns of the junctions
    for (const int block : order.kept) {
        starts[block] = static_cast<std::int64_t>(junction_rows_.size());
        for (int i = 0; i < partition.size(block); ++i) junction_rows_.push_back(partition.starts[block] + i);
    }
    const auto& places = layout.kept_blocks;
    std::vector<std::int64_t> rows;
    for (auto first = places.begin(); first != places.end();) {
        const int column = first->first.first;
        auto last = first;
        while (last != places.end() && last->first.first == column) ++last;
        rows.clear();
        for (auto i = first; i != last; ++i) {
            const int row = i->first.second;
            for (int j = 0; j < partition.size(row); ++j) rows.push_back(starts[row] + j);
        }
        const auto stride = static_cast<std::int64_t>(rows.size());
        std::int64_t slot = junctions_.nonzeros();
        for (auto i = first; i != last; ++i) {
            const int row = i->first.second;
            junction_blocks_.push_back(
                {i->second, slot, stride, partition.size(row), partition.size(column)});
            slot += partition.size(row);
        }
        junctions_.add_columns(partition.size(column), rows);
        first = last;
    }
    junction_values_.resize(static_cast<std::size_t>(junctions_.nonzeros()));
    junction_solver_ = make_general_solver(junctions_);
}

Factorization ChainSolver::factorize(const std::vector<double>& values) {
    values_ = &values;
    is_general_ = steps_.empty() || !kernels_.eliminate(chain(), values.data(), blocks_.data()) ||
                  !factorize_junctions();
    if (is_general_) return factorize_generally();
    general_.reset();  // a rare need's memory, of the size of all the rest
    return {};
}

bool ChainSolver::factorize_junctions() {
    if (!junction_solver_) return true;
    for (const JunctionBlock& block : junction_blocks_) {
        for (int j = 0; j < block.columns; ++j)
            std::copy_n(&blocks_[block.block + j * static_cast<std::int64_t>(block.rows)],
                        block.rows,
                        &junction_values_[block.slot + j * block.stride]);
    }
    return junction_solver_->factorize(junction_values_).regular;
}

Factorization ChainSolver::factorize_generally() {
    is_general_ = true;
    if (!general_) general_ = make_general_solver(*pattern_);
    return general_->factorize(*values_);
}

void ChainSolver::solve(Eigen::VectorXd& right_hand_side) {
    if (is_general_) return general_->solve(right_hand_side);
    solution_ = right_hand_side;
    solve_by_blocks(solution_);
    compute_residual(right_hand_side);
    if (!is_round_off()) {
        solve_by_blocks(residual_);
        solution_ += residual_;
        compute_residual(right_hand_side);
        if (!is_round_off() && factorize_generally().regular) return general_->solve(right_hand_side);
    }
    right_hand_side.swap(solution_);
}

void ChainSolver::solve_by_blocks(Eigen::VectorXd& x) {
    kernels_.go_forward(chain(), values_->data(), blocks_.data(), x.data());
    if (junction_solver_) {
        const auto count = static_cast<std::int64_t>(junction_rows_.size());
        junction_vector_.resize(count);
        for (std::int64_t i = 0; i < count; ++i) junction_vector_[i] = x[junction_rows_[i]];
        junction_solver_->solve(junction_vector_);
        for (std::int64_t i = 0; i < count; ++i) x[junction_rows_[i]] = junction_vector_[i];
    }
    kernels_.go_backward(chain(), blocks_.data(), x.data());
}

void ChainSolver::compute_residual(const Eigen::VectorXd& right_hand_side) {
    residual_ = right_hand_side;
    magnitudes_ = right_hand_side.cwiseAbs();
    kernels_.subtract(runs_.data(),
                      static_cast<std::int64_t>(runs_.size()),
                      values_->data(),
                      solution_.data(),
                      residual_.data(),
                      magnitudes_.data());
}

bool ChainSolver::is_round_off() const {
    Eigen::Index above = 0;
    for (Eigen::Index i = 0; i < residual_.size(); ++i) {
        above += std::abs(residual_[i]) <= round_off * magnitudes_[i] + smallest ? 0 : 1;
    }
    return above == 0;
}

}  // namespace gxrod
