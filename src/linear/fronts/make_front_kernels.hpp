#pragma once

#include "linear/fronts/dense_kernels.hpp"
#include "linear/fronts/front_kernels.hpp"

// For sources that are compiled for one instruction set, like block_kernels.hpp.
namespace gxrod {

template <class Arch>
struct FrontSweeps : DenseKernels<Arch> {
    using Dense = DenseKernels<Arch>;
    using View = typename Dense::View;
    using Target = typename Dense::Target;

    static void clear(double* entries, std::int64_t count) {
        for (std::int64_t i = 0; i < count; ++i) entries[i] = 0.0;
    }
    static void add(std::int64_t count, const double* from, double* to) {
        for (std::int64_t i = 0; i < count; ++i) to[i] += from[i];
    }

    // The parts of a front: L and U of its pivots, the rest of U, and the update.
    struct Parts {
        std::int64_t pivots, behind;
        Target lower, upper, update;
    };
    static Parts find_parts(const Front& front, double* factors, double* const* stacks) {
        const std::int64_t behind = front.rows - front.pivots;
        return {front.pivots,
                behind,
                {factors + front.lower, front.rows},
                {factors + front.upper, front.pivots},
                {stacks[front.stack] + front.update, behind}};
    }

    static void gather_values(const Fronts& fronts,
                              const Front& front,
                              const double* values,
                              double* factors) {
        for (std::int32_t c = 0; c < front.copy_count; ++c) {
            const FrontCopy& copy = fronts.copies[front.copies + c];
            for (std::int64_t j = 0; j < copy.columns; ++j) {
                const double* from = values + copy.from + j * copy.from_stride;
                double* to = factors + copy.to + j * copy.to_stride;
                for (std::int64_t i = 0; i < copy.rows; ++i) to[i] = from[i];
            }
        }
    }

    // Adds a column of a child's update to the column of the front.
    static void add_column(
        const Front& child, const FrontRun* runs, const double* from, std::int64_t column, const Parts& to) {
        const bool is_behind = column >= to.pivots;
        double* pivots = is_behind ? Dense::at(to.upper, 0, column - to.pivots).entries
                                   : Dense::at(to.lower, 0, column).entries;
        double* behind = is_behind ? Dense::at(to.update, 0, column - to.pivots).entries : pivots + to.pivots;
        for (std::int32_t r = 0; r < child.run_count; ++r) {
            const std::int64_t row = runs[r].above;
            add(runs[r].count, from, row < to.pivots ? pivots + row : behind + (row - to.pivots));
            from += runs[r].count;
        }
    }
    static void add_child(const Fronts& fronts, const Front& child, const double* update, const Parts& to) {
        const FrontRun* runs = fronts.runs + child.runs;
        const std::int64_t size = child.rows - child.pivots;
        for (std::int32_t r = 0; r < child.run_count; ++r) {
            for (std::int64_t j = 0; j < runs[r].count; ++j, update += size)
                add_column(child, runs, update, runs[r].above + j, to);
        }
    }

    static bool eliminate(const Fronts& fronts,
                          std::int64_t index,
                          const double* values,
                          double* factors,
                          double* const* stacks,
                          std::int64_t& negative_pivots) {
        const Front& front = fronts.fronts[index];
        const Parts parts = find_parts(front, factors, stacks);
        clear(parts.lower.entries, front.rows * parts.pivots);
        clear(parts.upper.entries, parts.pivots * parts.behind);
        clear(parts.update.entries, parts.behind * parts.behind);
        gather_values(fronts, front, values, factors);
        for (std::int32_t c = 0; c < front.child_count; ++c) {
            const Front& child = fronts.fronts[fronts.children[front.children + c]];
            add_child(fronts, child, stacks[child.stack] + child.update, parts);
        }
        if (!Dense::factorize_columns(front.rows, parts.pivots, parts.lower, negative_pivots)) return false;
        Dense::solve_lower(parts.pivots, parts.behind, Dense::view(parts.lower), parts.upper);
        Dense::subtract_large_product(parts.behind,
                                      parts.behind,
                                      parts.pivots,
                                      Dense::at(Dense::view(parts.lower), parts.pivots, 0),
                                      Dense::view(parts.upper),
                                      parts.update);
        return true;
    }

    // Computes y ← y − A x, column by column as A lies in memory.
    static void subtract_columns(
        std::int64_t rows, std::int64_t columns, const View& A, const double* x, double* y) {
        constexpr std::int64_t some = Dense::tile;
        std::int64_t j = 0;
        for (; j + some <= columns; j += some) {
            const double* a = A.entries + j * A.stride;
            for (std::int64_t i = 0; i < rows; ++i) {
                double sum = y[i];
                for (std::int64_t k = 0; k < some; ++k) sum -= a[i + k * A.stride] * x[j + k];
                y[i] = sum;
            }
        }
        for (; j < columns; ++j) {
            for (std::int64_t i = 0; i < rows; ++i) y[i] -= A.entries[i + j * A.stride] * x[j];
        }
    }

    static void go_forward(
        const Fronts& fronts, std::int64_t index, const double* factors, double* x, double* work) {
        const Front& front = fronts.fronts[index];
        const View L{factors + front.lower, front.rows};
        double* b = x + front.first;
        const FrontRun* runs = fronts.runs + front.runs;
        clear(work, front.rows - front.pivots);
        for (std::int64_t k = 0; k < front.pivots; k += Dense::tile) {
            const std::int64_t next = Dense::smaller(k + Dense::tile, front.pivots);
            Dense::multiply(static_cast<int>(next - k), 1, Dense::at(L, k, k), {b + k, front.pivots});
            subtract_columns(front.pivots - next, next - k, Dense::at(L, next, k), b + k, b + next);
            subtract_columns(front.rows - front.pivots, next - k, Dense::at(L, front.pivots, k), b + k, work);
        }
        for (std::int32_t r = 0; r < front.run_count; ++r) {
            add(runs[r].count, work, x + runs[r].unknown);
            work += runs[r].count;
        }
    }

    static void go_backward(
        const Fronts& fronts, std::int64_t index, const double* factors, double* x, double* work) {
        const Front& front = fronts.fronts[index];
        const FrontRun* runs = fronts.runs + front.runs;
        double* behind = work;
        for (std::int32_t r = 0; r < front.run_count; ++r) {
            for (std::int64_t i = 0; i < runs[r].count; ++i) *behind++ = x[runs[r].unknown + i];
        }
        const View L{factors + front.lower, front.rows};
        double* b = x + front.first;
        subtract_columns(
            front.pivots, front.rows - front.pivots, {factors + front.upper, front.pivots}, work, b);
        for (std::int64_t k = (front.pivots - 1) / Dense::tile * Dense::tile; k > 0; k -= Dense::tile) {
            const std::int64_t next = Dense::smaller(k + Dense::tile, front.pivots);
            subtract_columns(k, next - k, Dense::at(L, 0, k), b + k, b);
        }
    }

    static FrontKernels make() { return {eliminate, go_forward, go_backward}; }
};

}  // namespace gxrod
