#include "solvers/chain_solver.hpp"

#include <algorithm>
#include <cmath>
#include <map>

#include "solvers/block_kernels.hpp"

namespace gxrod {
namespace {

// As an element of the highest order that nothing else is tied to.
constexpr int largest_block = 30;

// What is left of a solution is round-off if its residual is so small against |A| |x| + |b|.
constexpr double round_off = 1e-13;

bool has_diagonal(const SparsePattern& pattern) {
    for (std::int64_t column = 0; column < pattern.size(); ++column) {
        const auto first = pattern.rows.begin() + pattern.column_starts[column];
        const auto last = pattern.rows.begin() + pattern.column_starts[column + 1];
        if (!std::binary_search(first, last, column)) return false;
    }
    return true;
}

// Visits the blocks of each column of blocks, with where their first entries are among the values.
template <class Visitor>
void visit_blocks(const SparsePattern& pattern, const BlockPartition& partition, Visitor&& visit) {
    for (int column = 0; column < partition.count(); ++column) {
        std::int64_t entry = pattern.column_starts[partition.starts[column]];
        bool is_diagonal_due = true;
        const auto visit_next = [&](int row) {
            visit(row, column, entry);
            entry += partition.size(row);
        };
        for (std::size_t i = partition.neighbour_starts[column]; i < partition.neighbour_starts[column + 1];
             ++i) {
            const int row = partition.neighbours[i];
            if (row > column && is_diagonal_due) {
                visit_next(column);
                is_diagonal_due = false;
            }
            visit_next(row);
        }
        if (is_diagonal_due) visit_next(column);
    }
}

}  // namespace

// Where each block of the matrix is worked on: those of a step together, in the order of the steps.
class ChainSolver::Layout {
  public:
    Layout(const BlockPartition& partition, const EliminationOrder& order)
        : partition_(partition),
          order_(order),
          steps_of_(partition.count(), -1),
          diagonals_(partition.count(), -1) {
        for (std::size_t s = 0; s < order.steps.size(); ++s) {
            const EliminationOrder::Step& step = order.steps[s];
            steps_of_[step.block] = static_cast<int>(s);
            diagonals_[step.block] = take(step.block, step.block);
            first_couplings_.push_back(size_);
            for (const int other : step.neighbours) {
                if (other < 0) continue;
                take(step.block, other);
                take(other, step.block);
            }
        }
        for (const int block : order.kept) diagonals_[block] = take(block, block);
    }

    std::int64_t size() const { return size_; }

    // Of a pair that is coupled, or will be by fill.
    std::int64_t find(int row, int column) {
        if (row == column) return diagonals_[row];
        const int step_of_row = steps_of_[row];
        const int step_of_column = steps_of_[column];
        if (step_of_row < 0 && step_of_column < 0) {
            const auto [found, is_new] = between_kept_.try_emplace({row, column}, size_);
            if (is_new) take(row, column);
            return found->second;
        }
        const bool is_row_first = step_of_column < 0 || (step_of_row >= 0 && step_of_row < step_of_column);
        const int first = is_row_first ? row : column;
        const int other = is_row_first ? column : row;
        const int step = is_row_first ? step_of_row : step_of_column;
        const std::int64_t entries = count(first, other);
        std::int64_t place = first_couplings_[step];
        if (order_.steps[step].neighbours[0] != other)
            place += 2 * count(first, order_.steps[step].neighbours[0]);
        return is_row_first ? place : place + entries;
    }

    // Of kept blocks, by row and column.
    const std::map<std::pair<int, int>, std::int64_t>& between_kept() const { return between_kept_; }

  private:
    std::int64_t count(int row, int column) const {
        return static_cast<std::int64_t>(partition_.size(row)) * partition_.size(column);
    }
    std::int64_t take(int row, int column) {
        const std::int64_t place = size_;
        size_ += count(row, column);
        return place;
    }

    const BlockPartition& partition_;
    const EliminationOrder& order_;
    std::vector<int> steps_of_;  // −1 of a kept block
    std::vector<std::int64_t> diagonals_;
    std::vector<std::int64_t> first_couplings_;
    std::map<std::pair<int, int>, std::int64_t> between_kept_;
    std::int64_t size_ = 0;
};

ChainSolver::ChainSolver(const SparsePattern& pattern) : pattern_(&pattern) {
    if (!has_diagonal(pattern)) return;
    const BlockPartition partition(pattern);
    const EliminationOrder order(partition, largest_block);
    if (order.steps.empty()) return;
    Layout layout(partition, order);
    visit_blocks(pattern, partition, [&](int row, int column, std::int64_t entry) {
        const std::int64_t first_column = partition.starts[column];
        sources_.push_back(
            {.first = entry,
             .stride = pattern.column_starts[first_column + 1] - pattern.column_starts[first_column],
             .block = layout.find(row, column),
             .row = partition.starts[row],
             .column = first_column,
             .rows = partition.size(row),
             .columns = partition.size(column)});
    });
    for (const EliminationOrder::Step& eliminated : order.steps) {
        Step step{};
        step.diagonal = layout.find(eliminated.block, eliminated.block);
        step.row = partition.starts[eliminated.block];
        step.size = partition.size(eliminated.block);
        for (std::size_t i = 0; i < 2; ++i) {
            const int other = eliminated.neighbours[i];
            if (other < 0) continue;
            step.neighbours[i] = {.to = layout.find(eliminated.block, other),
                                  .from = layout.find(other, eliminated.block),
                                  .diagonal = layout.find(other, other),
                                  .row = partition.starts[other],
                                  .size = partition.size(other)};
        }
        const auto [a, b] = eliminated.neighbours;
        if (b >= 0) {
            step.across = layout.find(a, b);
            step.back = layout.find(b, a);
            step.fills = eliminated.fills;
        }
        steps_.push_back(step);
    }
    lay_out_junctions(partition, order, layout);
    blocks_.resize(static_cast<std::size_t>(layout.size()));
}

void ChainSolver::lay_out_junctions(const BlockPartition& partition,
                                    const EliminationOrder& order,
                                    Layout& layout) {
    if (order.kept.empty()) return;
    std::vector<std::int64_t> starts(partition.count(), -1);  // among the unknowns of the junctions
    for (const int block : order.kept) {
        starts[block] = static_cast<std::int64_t>(junction_rows_.size());
        for (int i = 0; i < partition.size(block); ++i) junction_rows_.push_back(partition.starts[block] + i);
    }
    std::map<std::pair<int, int>, std::int64_t> places;  // by column and row
    for (const auto& [pair, place] : layout.between_kept()) places[{pair.second, pair.first}] = place;
    for (const int block : order.kept) places[{block, block}] = layout.find(block, block);
    for (auto first = places.begin(); first != places.end();) {
        const int column = first->first.first;
        auto last = first;
        while (last != places.end() && last->first.first == column) ++last;
        std::int64_t stride = 0;
        for (auto i = first; i != last; ++i) stride += partition.size(i->first.second);
        std::int64_t slot = junctions_.nonzeros();
        for (auto i = first; i != last; ++i) {
            const int row = i->first.second;
            junction_blocks_.push_back(
                {i->second, slot, stride, partition.size(row), partition.size(column)});
            slot += partition.size(row);
        }
        for (int k = 0; k < partition.size(column); ++k) {
            for (auto i = first; i != last; ++i) {
                const int row = i->first.second;
                for (int j = 0; j < partition.size(row); ++j) junctions_.rows.push_back(starts[row] + j);
            }
            junctions_.column_starts.push_back(junctions_.nonzeros());
        }
        first = last;
    }
    junction_values_.resize(junctions_.rows.size());
    junction_solver_ = make_general_solver(junctions_);
}

Factorization ChainSolver::factorize(const std::vector<double>& values) {
    values_ = &values;
    for (const Source& source : sources_) {
        copy_block({source.rows, source.columns, source.stride, &values[source.first]},
                   &blocks_[source.block]);
    }
    for (const Step& step : steps_) {
        if (!step.fills) continue;
        const int count = step.neighbours[0].size * step.neighbours[1].size;
        std::fill_n(&blocks_[step.across], count, 0.0);
        std::fill_n(&blocks_[step.back], count, 0.0);
    }
    is_general_ = steps_.empty() || !eliminate() || !factorize_junctions();
    return is_general_ ? factorize_generally() : Factorization{};
}

bool ChainSolver::eliminate() {
    for (const Step& step : steps_) {
        if (!eliminate(step)) return false;
    }
    return true;
}

// D_t ← D_t⁻¹ and A_tu ← D_t⁻¹ A_tu; A_uv ← A_uv − A_ut D_t⁻¹ A_tv.
bool ChainSolver::eliminate(const Step& step) {
    const int n = step.size;
    double* D = &blocks_[step.diagonal];
    if (!invert_block(n, D)) return false;
    std::array<double, largest_block * largest_block> kept;
    for (const Coupling& u : step.neighbours) {
        if (u.size == 0) continue;
        double* to = &blocks_[u.to];
        std::copy_n(to, n * u.size, kept.data());
        multiply_blocks(n, u.size, D, kept.data(), to);
        subtract_product(u.size, n, u.size, &blocks_[u.from], to, &blocks_[u.diagonal]);
    }
    const auto& [u, v] = step.neighbours;
    if (v.size == 0) return true;
    subtract_product(u.size, n, v.size, &blocks_[u.from], &blocks_[v.to], &blocks_[step.across]);
    subtract_product(v.size, n, u.size, &blocks_[v.from], &blocks_[u.to], &blocks_[step.back]);
    return true;
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
    Eigen::VectorXd solution = solve_by_blocks(right_hand_side);
    Eigen::VectorXd residual = compute_residual(right_hand_side, solution);
    if (!is_round_off(residual)) {
        solution += solve_by_blocks(residual);
        residual = compute_residual(right_hand_side, solution);
        if (!is_round_off(residual) && factorize_generally().regular) {
            return general_->solve(right_hand_side);
        }
    }
    right_hand_side = solution;
}

Eigen::VectorXd ChainSolver::solve_by_blocks(Eigen::VectorXd x) {
    std::array<double, largest_block> kept;
    for (const Step& step : steps_) {
        double* x_t = &x[step.row];
        std::copy_n(x_t, step.size, kept.data());
        multiply_blocks(step.size, 1, &blocks_[step.diagonal], kept.data(), x_t);
        for (const Coupling& u : step.neighbours) {
            if (u.size > 0) subtract_product(u.size, step.size, 1, &blocks_[u.from], x_t, &x[u.row]);
        }
    }
    if (junction_solver_) {
        Eigen::VectorXd junctions(junctions_.size());
        for (std::int64_t i = 0; i < junctions.size(); ++i) junctions[i] = x[junction_rows_[i]];
        junction_solver_->solve(junctions);
        for (std::int64_t i = 0; i < junctions.size(); ++i) x[junction_rows_[i]] = junctions[i];
    }
    for (auto step = steps_.rbegin(); step != steps_.rend(); ++step) {
        for (const Coupling& u : step->neighbours) {
            if (u.size > 0) subtract_product(step->size, u.size, 1, &blocks_[u.to], &x[u.row], &x[step->row]);
        }
    }
    return x;
}

// b − A x; |A| |x| + |b| goes into magnitudes_.
Eigen::VectorXd ChainSolver::compute_residual(const Eigen::VectorXd& right_hand_side,
                                              const Eigen::VectorXd& x) {
    Eigen::VectorXd residual = right_hand_side;
    magnitudes_ = right_hand_side.cwiseAbs();
    for (const Source& source : sources_) {
        subtract_with_magnitudes({source.rows, source.columns, source.stride, &(*values_)[source.first]},
                                 &x[source.column],
                                 &residual[source.row],
                                 &magnitudes_[source.row]);
    }
    return residual;
}

bool ChainSolver::is_round_off(const Eigen::VectorXd& residual) const {
    for (Eigen::Index i = 0; i < residual.size(); ++i) {
        if (!(std::abs(residual[i]) <= round_off * magnitudes_[i])) return false;
    }
    return true;
}

}  // namespace gxrod
