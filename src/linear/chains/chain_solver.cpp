#include "linear/chains/chain_solver.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

namespace gxrod {
namespace {

// A solution is as good as it gets if its residual is so small against |A| |x| + |b|: without pivoting it may
// be worse, which costs statics of slender rods an iteration. Refined, it is good enough at the second.
constexpr double round_off = 5e-15;
constexpr double good_enough = 1e-13;
// Nearly always one will do; where rods touch, a few more cost less than an elimination with pivots.
constexpr int most_refinements = 4;
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

void copy_block(const BlockCopy& copy, const double* values, double* blocks) {
    for (int column = 0; column < copy.columns; ++column) {
        double* to = blocks + copy.to + column * copy.rows;
        if (copy.from < 0) {
            std::fill_n(to, copy.rows, 0.0);
        } else {
            std::copy_n(values + copy.from + column * std::int64_t{copy.stride}, copy.rows, to);
        }
    }
}

// Runs that change different rows can be worked on at once; rows count by eights.
WorkPhases find_run_phases(const std::vector<EntryRun>& runs, std::int64_t rows) {
    constexpr int together = 8;
    return {
        runs.size(), static_cast<std::size_t>(rows / together + 1), [&](std::size_t run, const auto& mark) {
            const int last = (runs[run].row + runs[run].rows - 1) / together;
            for (int row = runs[run].row / together; row <= last; ++row) mark(row);
        }};
}

}  // namespace

ChainSolver::ChainSolver(const SparsePattern& pattern, const ThreadTeam& team)
    : pattern_(&pattern), team_(&team), kernels_(find_chain_kernels(find_instruction_set())) {
    // Steps count unknowns in 32 bits; a block has fewer rows and columns than there are unknowns.
    if (pattern.size() > std::numeric_limits<std::int32_t>::max() || !has_diagonal(pattern)) return;
    std::int64_t size = 0;
    {
        const BlockPartition partition(pattern);
        runs_ = find_entry_runs(pattern);
        run_phases_ = find_run_phases(runs_, pattern.size());
        EliminationOrder order(partition, largest_chain_block);
        if (order.steps.empty()) {
            if (pattern.size() > 0) junction_solver_ = std::make_unique<FrontSolver>(pattern);
            return;
        }
        const EliminationTasks tasks(partition, order.steps);
        ChainLayout layout(pattern, partition, order, tasks);
        lay_out_junctions(partition, order, layout);
        steps_ = std::move(layout.steps);
        couplings_ = std::move(layout.couplings);
        copies_ = std::move(layout.copies);
        tasks_ = std::move(layout.tasks);
        level_starts_ = std::move(layout.level_starts);
        first_copies_ = std::move(layout.first_copies);
        merges_ = std::move(layout.merges);
        vector_merges_ = std::move(layout.vector_merges);
        apart_.resize(static_cast<std::size_t>(layout.apart));
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
    junction_solver_ = std::make_unique<FrontSolver>(junctions_);
}

Factorization ChainSolver::factorize(const std::vector<double>& values) {
    values_ = &values;
    is_general_ = !works_by_blocks() || !eliminate() || !factorize_junctions();
    if (is_general_) return factorize_generally();
    general_.reset();  // a rare need's memory, of the size of all the rest
    return {.negative_pivots =
                negative_pivots_ + (junction_solver_ ? junction_solver_->negative_pivots() : 0)};
}

bool ChainSolver::eliminate() {
    std::vector<char> is_regular(tasks_.size(), 1);
    std::vector<std::int64_t> negative_pivots(tasks_.size(), 0);
    for (std::size_t level = 0; level + 1 < level_starts_.size(); ++level) {
        const std::size_t first = level_starts_[level];
        team_->for_each(level_starts_[level + 1] - first, [&](std::size_t task) {
            is_regular[first + task] = eliminate(tasks_[first + task], negative_pivots[first + task]) ? 1 : 0;
        });
        if (std::count(is_regular.begin(), is_regular.end(), 0) > 0) return false;
    }
    negative_pivots_ = std::accumulate(negative_pivots.begin(), negative_pivots.end(), std::int64_t{0});
    return true;
}

bool ChainSolver::eliminate(const ChainTask& task, std::int64_t& negative_pivots) {
    for (std::int64_t i = 0; i < task.first_copies.count; ++i)
        copy_block(first_copies_[task.first_copies.first + i], values_->data(), blocks_.data());
    for (std::int64_t i = 0; i < task.merges.count; ++i) {
        const auto [from, to, size] = merges_[task.merges.first + i];
        for (std::int32_t k = 0; k < size; ++k) blocks_[to + k] += blocks_[from + k];
    }
    return kernels_.eliminate(steps_of(task), values_->data(), blocks_.data(), negative_pivots);
}

bool ChainSolver::factorize_junctions() {
    if (!junction_solver_) return true;
    if (steps_.empty()) return junction_solver_->factorize(*values_);
    for (const JunctionBlock& block : junction_blocks_) {
        for (int j = 0; j < block.columns; ++j)
            std::copy_n(&blocks_[block.block + j * static_cast<std::int64_t>(block.rows)],
                        block.rows,
                        &junction_values_[block.slot + j * block.stride]);
    }
    return junction_solver_->factorize(junction_values_);
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
    if (!is_solved(round_off)) {
        for (int refinement = 0; refinement < most_refinements; ++refinement) {
            solve_by_blocks(residual_);
            solution_ += residual_;
            compute_residual(right_hand_side);
            if (is_solved(good_enough)) break;
        }
        if (!is_solved(good_enough) && factorize_generally().regular) return general_->solve(right_hand_side);
    }
    right_hand_side.swap(solution_);
}

void ChainSolver::solve_by_blocks(Eigen::VectorXd& x) {
    if (steps_.empty()) return junction_solver_->solve(x);
    for (std::size_t level = 0; level + 1 < level_starts_.size(); ++level) {
        const std::size_t first = level_starts_[level];
        team_->for_each(level_starts_[level + 1] - first,
                        [&](std::size_t task) { go_forward(tasks_[first + task], x.data()); });
    }
    if (junction_solver_) {
        const auto count = static_cast<std::int64_t>(junction_rows_.size());
        junction_vector_.resize(count);
        for (std::int64_t i = 0; i < count; ++i) junction_vector_[i] = x[junction_rows_[i]];
        junction_solver_->solve(junction_vector_);
        for (std::int64_t i = 0; i < count; ++i) x[junction_rows_[i]] = junction_vector_[i];
    }
    for (std::size_t level = level_starts_.size() - 1; level-- > 0;) {
        const std::size_t first = level_starts_[level];
        team_->for_each(level_starts_[level + 1] - first, [&](std::size_t task) {
            kernels_.go_backward(steps_of(tasks_[first + task]), blocks_.data(), x.data());
        });
    }
}

void ChainSolver::go_forward(const ChainTask& task, double* x) {
    for (std::int64_t i = 0; i < task.vector_merges.count; ++i) {
        const auto [from, to, size] = vector_merges_[task.vector_merges.first + i];
        for (std::int32_t k = 0; k < size; ++k) x[to + k] += apart_[from + k];
    }
    std::fill_n(apart_.data() + task.apart.first, task.apart.count, 0.0);
    kernels_.go_forward(steps_of(task), values_->data(), blocks_.data(), x, apart_.data());
}

void ChainSolver::compute_residual(const Eigen::VectorXd& right_hand_side) {
    const auto size = static_cast<std::size_t>(right_hand_side.size());
    residual_.resize(right_hand_side.size());
    magnitudes_.resize(right_hand_side.size());
    team_->for_each_range(size, [&](std::size_t first, std::size_t last) {
        for (std::size_t i = first; i < last; ++i) {
            residual_[i] = right_hand_side[i];
            magnitudes_[i] = std::abs(right_hand_side[i]);
        }
    });
    run_phases_.run(*team_, [&](std::size_t part) {
        kernels_.subtract(&runs_[run_phases_.first(part)],
                          static_cast<std::int64_t>(run_phases_.last(part) - run_phases_.first(part)),
                          values_->data(),
                          solution_.data(),
                          residual_.data(),
                          magnitudes_.data());
    });
}

bool ChainSolver::is_solved(double tolerance) const {
    const auto size = static_cast<std::size_t>(residual_.size());
    const auto count_above = [&](std::size_t first, std::size_t last) {
        int above = 0;
        for (std::size_t i = first; i < last; ++i)
            above += std::abs(residual_[i]) <= tolerance * magnitudes_[i] + smallest ? 0 : 1;
        return above;
    };
    const std::vector<int> above = team_->collect<int>(size, count_above);
    return std::all_of(above.begin(), above.end(), [](int count) { return count == 0; });
}

}  // namespace gxrod
