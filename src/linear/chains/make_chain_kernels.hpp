#pragma once

#include "linear/chains/block_kernels.hpp"
#include "linear/chains/chain_kernels.hpp"

// For sources that are compiled for one instruction set, like block_kernels.hpp.
namespace gxrod {

template <class Arch>
struct ChainSweeps : BlockKernels<Arch> {
    using Blocks = BlockKernels<Arch>;
    using View = typename Blocks::View;

    static View view(const BlockPlace& place, const double* values, const double* blocks) {
        return {(place.is_given ? values : blocks) + place.first, place.stride};
    }

    static void copy_from_values(const BlockCopy& copy, const double* values, double* blocks) {
        double* to = blocks + copy.to;
        if (copy.from >= 0)
            return Blocks::copy(copy.rows, copy.columns, {values + copy.from, copy.stride}, to);
        for (int i = 0; i < copy.rows * copy.columns; ++i) to[i] = 0.0;
    }

    static bool eliminate_step(const ChainStep& step,
                               const ChainCoupling* couplings,
                               const double* values,
                               double* blocks,
                               std::int64_t& negative_pivots) {
        const int n = step.size;
        double* D = blocks + step.diagonal;
        if (!Blocks::factorize(n, D, negative_pivots)) return false;
        for (int i = 0; i < step.couplings; ++i) {
            const ChainCoupling& u = couplings[i];
            Blocks::solve(n, u.size, D, view(u.row, values, blocks), blocks + u.to);
        }
        for (int i = 0; i < step.couplings; ++i) {
            for (int j = 0; j < step.couplings; ++j) {
                const ChainCoupling& u = couplings[i];
                const ChainCoupling& v = couplings[j];
                const std::int64_t place = i == j ? u.diagonal : i < j ? step.across : step.back;
                Blocks::subtract_product(u.size,
                                         n,
                                         v.size,
                                         view(u.column, values, blocks),
                                         {blocks + v.to, n},
                                         {blocks + place, u.size});
            }
        }
        return true;
    }

    // Prefetches, since processors do not detect early enough reads from the end to the start: for a coupling
    // some steps ahead, the columns of A_ut, and with them the diagonal that follows.
    static void fetch_ahead(const ChainSteps& chain, const ChainCoupling* at, const double* values) {
        constexpr int ahead = 8;
        constexpr int line = 8;
        constexpr int columns = 6;  // columns of a node
        if (at - chain.couplings + ahead >= chain.coupling_count) return;
        const ChainCoupling& u = at[ahead];
        if (!u.column.is_given) return;
        const double* column = values + u.column.first;
        for (int i = 0; i < columns; ++i, column += u.column.stride) {
            __builtin_prefetch(column);
            __builtin_prefetch(column + line);
        }
    }

    static bool eliminate(const ChainSteps& chain,
                          const double* values,
                          double* blocks,
                          std::int64_t& negative_pivots) {
        const ChainCoupling* couplings = chain.couplings;
        const BlockCopy* copies = chain.copies;
        for (std::int64_t s = 0; s < chain.count; ++s) {
            const ChainStep& step = chain.steps[s];
            fetch_ahead(chain, couplings, values);
            for (int i = 0; i < step.copies; ++i) copy_from_values(*copies++, values, blocks);
            if (!eliminate_step(step, couplings, values, blocks, negative_pivots)) return false;
            couplings += step.couplings;
        }
        return true;
    }

    static void go_forward(
        const ChainSteps& chain, const double* values, const double* blocks, double* x, double* apart) {
        const ChainCoupling* u = chain.couplings;
        for (std::int64_t s = 0; s < chain.count; ++s) {
            const ChainStep& step = chain.steps[s];
            const int n = step.size;
            double* x_t = x + step.first;
            fetch_ahead(chain, u, values);
            Blocks::solve(n, 1, blocks + step.diagonal, {x_t, n}, x_t);
            for (int i = 0; i < step.couplings; ++i, ++u) {
                const View A = view(u->column, values, blocks);
                double* x_u = u->apart < 0 ? x + u->first : apart + u->apart;
                Blocks::subtract_product(u->size, n, 1, A, {x_t, n}, {x_u, u->size});
            }
        }
    }

    static void go_backward(const ChainSteps& chain, const double* blocks, double* x) {
        constexpr std::int64_t ahead = 512;
        constexpr int line = 8;
        const ChainCoupling* u = chain.couplings + chain.coupling_count;
        for (std::int64_t s = chain.count - 1; s >= 0; --s) {
            const ChainStep& step = chain.steps[s];
            const int n = step.size;
            for (int i = 0; i < step.couplings; ++i) {
                --u;
                // Prefetches likewise (fetch_ahead).
                if (u->to >= ahead) {
                    for (int k = 0; k < n * u->size; k += line)
                        __builtin_prefetch(blocks + u->to - ahead + k);
                }
                Blocks::subtract_product(
                    n, u->size, 1, {blocks + u->to, n}, {x + u->first, u->size}, {x + step.first, n});
            }
        }
    }

    static void add_absolute(double& sum, double number) { sum += number < 0.0 ? -number : number; }
    static void add_absolute(TwoNumbers& sum, const TwoNumbers& numbers) {
        using Bits = long long __attribute__((vector_size(16)));
        sum += reinterpret_cast<TwoNumbers>(reinterpret_cast<Bits>(numbers) & all_but_sign);
    }
    static void add_absolute(FourNumbers& sum, const FourNumbers& numbers) {
        using Bits = long long __attribute__((vector_size(32)));
        sum += reinterpret_cast<FourNumbers>(reinterpret_cast<Bits>(numbers) & all_but_sign);
    }
    static constexpr long long all_but_sign = 0x7fffffffffffffff;

    template <class Numbers>
    static void subtract_rows(
        const EntryRun& run, const double* values, const double* x, double* y, double* sums) {
        Numbers left = *reinterpret_cast<const Numbers*>(y);
        Numbers sum = *reinterpret_cast<const Numbers*>(sums);
        for (int j = 0; j < run.columns; ++j) {
            const Numbers entries = *reinterpret_cast<const Numbers*>(values + j * std::int64_t{run.stride});
            const Numbers product = entries * x[j];
            left -= product;
            add_absolute(sum, product);
        }
        *reinterpret_cast<Numbers*>(y) = left;
        *reinterpret_cast<Numbers*>(sums) = sum;
    }

    static void subtract(const EntryRun* runs,
                         std::int64_t count,
                         const double* values,
                         const double* x,
                         double* y,
                         double* sums) {
        for (std::int64_t r = 0; r < count; ++r) {
            const EntryRun& run = runs[r];
            const double* entries = values + run.first;
            const double* x_r = x + run.column;
            double* y_r = y + run.row;
            double* sums_r = sums + run.row;
            int i = 0;
            for (; i + 4 <= run.rows; i += 4)
                subtract_rows<FourNumbers>(run, entries + i, x_r, y_r + i, sums_r + i);
            for (; i + 2 <= run.rows; i += 2)
                subtract_rows<TwoNumbers>(run, entries + i, x_r, y_r + i, sums_r + i);
            for (; i < run.rows; ++i) subtract_rows<double>(run, entries + i, x_r, y_r + i, sums_r + i);
        }
    }

    static ChainKernels make() { return {eliminate, go_forward, go_backward, subtract}; }
};

}  // namespace gxrod
