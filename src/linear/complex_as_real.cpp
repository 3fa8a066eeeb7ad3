#include "linear/complex_as_real.hpp"

#include <algorithm>

namespace gxrod {

// Blocks of columns are those of rows too, since the pattern is symmetric: where a run of rows begins or ends
// within a block of columns, that block is cut.
SparsePattern ComplexAsReal::make_doubled(const SparsePattern& pattern, std::vector<Rows>& blocks) {
    std::vector<std::int64_t> cuts{0};
    for (std::size_t i = 0; i < pattern.block_count(); ++i) {
        const SparsePattern::Block block = pattern.block(i);
        cuts.push_back(block.first_column + block.columns);
        for (const SparsePattern::RowRun& run : block.runs) {
            cuts.push_back(run.first);
            cuts.push_back(run.first + run.count);
        }
    }
    std::ranges::sort(cuts);
    cuts.erase(std::unique(cuts.begin(), cuts.end()), cuts.end());
    for (std::size_t i = 0; i + 1 < cuts.size(); ++i) blocks.push_back({cuts[i], cuts[i + 1] - cuts[i]});

    SparsePattern doubled;
    doubled.reserve(blocks.size());
    std::vector<std::int64_t> rows;
    for (const Rows& own : blocks) {
        rows.clear();
        for (const SparsePattern::RowRun& run : pattern.block_of(own.first).runs) {
            for (std::int64_t row = 2 * run.first; row < 2 * (run.first + run.count); ++row)
                rows.push_back(row);
        }
        doubled.add_columns(2 * own.count, rows);
    }
    return doubled;
}

ComplexAsReal::ComplexAsReal(LinearSolverKind kind, const SparsePattern& pattern, const ThreadTeam& team)
    : pattern_(&pattern),
      doubled_(make_doubled(pattern, blocks_)),
      solver_(make_linear_solver(kind, doubled_, team)) {}

Factorization ComplexAsReal::factorize(const std::vector<double>& real,
                                       const std::vector<double>& imaginary,
                                       const Eigen::VectorXcd& factors) {
    factors_ = factors;
    values_.resize(static_cast<std::size_t>(doubled_.nonzeros()));
    for (const Rows& own : blocks_) {
        const SparsePattern::Block from = pattern_->block_of(own.first);
        const SparsePattern::Block to = doubled_.block_of(2 * own.first);
        for (std::int64_t column = 0; column < own.count; ++column) {
            std::int64_t slot = from.first_entry + (own.first - from.first_column + column) * from.stride;
            double* left = &values_[static_cast<std::size_t>(
                to.first_entry + (2 * own.first - to.first_column + column) * to.stride)];
            double* right = left + own.count * to.stride;
            for (const SparsePattern::RowRun& run : from.runs) {
                auto block = std::ranges::lower_bound(blocks_, run.first, {}, &Rows::first);
                for (std::int64_t done = 0; done < run.count; done += block->count, ++block) {
                    for (std::int64_t i = 0; i < block->count; ++i, ++slot) {
                        const std::complex<double> value =
                            factors[block->first + i] *
                            std::complex<double>(real[static_cast<std::size_t>(slot)],
                                                 imaginary[static_cast<std::size_t>(slot)]);
                        left[i] = right[block->count + i] = value.real();
                        left[block->count + i] = value.imag();
                        right[i] = -value.imag();
                    }
                    left += 2 * block->count;
                    right += 2 * block->count;
                }
            }
        }
    }
    return solver_->factorize(values_);
}

void ComplexAsReal::solve(Eigen::VectorXcd& right_hand_side) {
    vector_.resize(2 * right_hand_side.size());
    for (const Rows& own : blocks_) {
        for (std::int64_t i = 0; i < own.count; ++i) {
            const std::complex<double> value = factors_[own.first + i] * right_hand_side[own.first + i];
            vector_[2 * own.first + i] = value.real();
            vector_[2 * own.first + own.count + i] = value.imag();
        }
    }
    solver_->solve(vector_);
    for (const Rows& own : blocks_) {
        for (std::int64_t i = 0; i < own.count; ++i)
            right_hand_side[own.first + i] = {vector_[2 * own.first + i],
                                              vector_[2 * own.first + own.count + i]};
    }
}

}  // namespace gxrod
