#pragma once

#include <cstdint>

#include "linear/chains/block_kernels.hpp"

// Arithmetic of dense matrices of any size, for sources that are compiled for one instruction set, on tiles
// of 6 × 6 by BlockKernels. Products are subtracted from each entry one by one, in the order of elimination,
// so that the bits depend neither on the instruction set nor on the division of the work.
namespace gxrod {

template <class Arch>
struct DenseKernels : BlockKernels<Arch> {
    using Blocks = BlockKernels<Arch>;
    using View = typename Blocks::View;
    using Target = typename Blocks::Target;
#if defined(__AVX512F__)
    using Vector = EightNumbers;
    static constexpr int wide = 6;  // columns of C in registers
#elif defined(__AVX__)
    using Vector = FourNumbers;
    static constexpr int wide = 3;
#else
    using Vector = TwoNumbers;
    static constexpr int wide = 3;
#endif
    static constexpr int lanes = sizeof(Vector) / sizeof(double);
    static constexpr int high = 3;  // vectors of each column
    static constexpr int high_rows = high * lanes;
    // Sizes of slices of A and B: rows of A then stay in the nearest cache, and B in the next.
    static constexpr std::int64_t deep = 96;
    static constexpr std::int64_t broad = 192;
    static constexpr std::int64_t many_columns = 12;  // from here on rows of A are first packed side by side

    static View at(const View& A, std::int64_t row, std::int64_t column) {
        return {A.entries + row + column * A.stride, A.stride};
    }
    static Target at(const Target& A, std::int64_t row, std::int64_t column) {
        return {A.entries + row + column * A.stride, A.stride};
    }
    static std::int64_t smaller(std::int64_t a, std::int64_t b) { return a < b ? a : b; }
    static View view(const Target& A) { return {A.entries, A.stride}; }

    // Computes C ← C − A B with so few rows and columns that C stays in registers.
    template <class Numbers, int Rows, int Columns>
    static void subtract_tile(std::int64_t depth, const View& A, const View& B, const Target& C) {
        constexpr int step = sizeof(Numbers) / sizeof(double);
        Numbers c[Columns][Rows];
        for (int j = 0; j < Columns; ++j) {
            for (int i = 0; i < Rows; ++i)
                c[j][i] = *reinterpret_cast<const Numbers*>(C.entries + j * C.stride + i * step);
        }
        const double* a = A.entries;
        for (std::int64_t k = 0; k < depth; ++k, a += A.stride) {
            Numbers column[Rows];
            for (int i = 0; i < Rows; ++i) column[i] = *reinterpret_cast<const Numbers*>(a + i * step);
            for (int j = 0; j < Columns; ++j) {
                const double b = B.entries[j * B.stride + k];
                for (int i = 0; i < Rows; ++i) c[j][i] -= column[i] * b;
            }
        }
        for (int j = 0; j < Columns; ++j) {
            for (int i = 0; i < Rows; ++i)
                *reinterpret_cast<Numbers*>(C.entries + j * C.stride + i * step) = c[j][i];
        }
    }
    template <class Numbers, int Rows>
    static void subtract_rows(
        std::int64_t columns, std::int64_t depth, const View& A, const View& B, const Target& C) {
        std::int64_t j = 0;
        for (; j + wide <= columns; j += wide) {
            // Prefetches, since processors do not prefetch reads across columns early enough.
            for (std::int64_t next = j + wide; next < smaller(j + 2 * wide, columns); ++next) {
                __builtin_prefetch(C.entries + next * C.stride);
                __builtin_prefetch(C.entries + next * C.stride + Rows * sizeof(Numbers) / sizeof(double) - 1);
            }
            subtract_tile<Numbers, Rows, wide>(depth, A, at(B, 0, j), at(C, 0, j));
        }
        for (; j < columns; ++j) subtract_tile<Numbers, Rows, 1>(depth, A, at(B, 0, j), at(C, 0, j));
    }

    static void put_side_by_side(std::int64_t depth, const View& A, double* rows) {
        for (std::int64_t k = 0; k < depth; ++k) {
            for (int i = 0; i < high_rows; i += lanes)
                *reinterpret_cast<Vector*>(rows + k * high_rows + i) =
                    *reinterpret_cast<const Vector*>(A.entries + k * A.stride + i);
        }
    }

    // Computes C ← C − A B for rows × depth and depth × columns. C must not overlap A or B.
    static void subtract_large_product(std::int64_t rows,
                                       std::int64_t columns,
                                       std::int64_t depth,
                                       const View& A,
                                       const View& B,
                                       const Target& C) {
        for (std::int64_t j = 0; j < columns; j += broad) {
            const std::int64_t some_columns = smaller(broad, columns - j);
            for (std::int64_t k = 0; k < depth; k += deep)
                subtract_slice(
                    rows, some_columns, smaller(deep, depth - k), at(A, 0, k), at(B, k, j), at(C, 0, j));
        }
    }
    // Computes the same for a moderate depth.
    static void subtract_slice(std::int64_t rows,
                               std::int64_t columns,
                               std::int64_t depth,
                               const View& A,
                               const View& B,
                               const Target& C) {
        std::int64_t i = 0;
        double side_by_side[deep * high_rows];
        for (; i + high_rows <= rows; i += high_rows) {
            View some_rows = at(A, i, 0);
            if (columns >= many_columns) {
                put_side_by_side(depth, some_rows, side_by_side);
                some_rows = {side_by_side, high_rows};
            }
            subtract_rows<Vector, high>(columns, depth, some_rows, B, at(C, i, 0));
        }
        for (; i + lanes <= rows; i += lanes)
            subtract_rows<Vector, 1>(columns, depth, at(A, i, 0), B, at(C, i, 0));
        if constexpr (lanes > 4) {
            for (; i + 4 <= rows; i += 4)
                subtract_rows<FourNumbers, 1>(columns, depth, at(A, i, 0), B, at(C, i, 0));
        }
        for (; i + 2 <= rows; i += 2)
            subtract_rows<TwoNumbers, 1>(columns, depth, at(A, i, 0), B, at(C, i, 0));
        for (; i < rows; ++i) subtract_rows<double, 1>(columns, depth, at(A, i, 0), B, at(C, i, 0));
    }

    // Returns the place between tiles at which a range of rows or columns is halved.
    static std::int64_t halve(std::int64_t count) {
        constexpr std::int64_t tile = Blocks::tile;
        return (count / 2 + tile - 1) / tile * tile;
    }

    // Factorizes A = L U of rows × columns, rows ≥ columns, in place, in tiles; the diagonal has the inverses
    // of L's tiles, the diagonal tiles of U are 1. There is no pivoting; returns false if a pivot vanishes.
    static bool factorize_columns(std::int64_t rows,
                                  std::int64_t columns,
                                  const Target& A,
                                  std::int64_t& negative_pivots) {
        if (columns <= Blocks::tile) return invert(static_cast<int>(columns), A, negative_pivots);
        const std::int64_t half = halve(columns);
        const Target right = at(A, 0, half);
        if (!factorize_columns(rows, half, A, negative_pivots)) return false;
        solve_lower(half, columns - half, view(A), right);
        subtract_large_product(
            rows - half, columns - half, half, at(view(A), half, 0), view(right), at(right, half, 0));
        return factorize_columns(rows - half, columns - half, at(A, half, half), negative_pivots);
    }

    // Computes B ← L⁻¹ B of n × columns.
    static void solve_lower(std::int64_t n, std::int64_t columns, const View& L, const Target& B) {
        if (n <= Blocks::tile) return multiply(static_cast<int>(n), columns, L, B);
        const std::int64_t half = halve(n);
        solve_lower(half, columns, L, B);
        subtract_large_product(n - half, columns, half, at(L, half, 0), view(B), at(B, half, 0));
        solve_lower(n - half, columns, at(L, half, half), at(B, half, 0));
    }

    // Computes A ← A⁻¹ for a tile or less.
    static bool invert(int n, const Target& A, std::int64_t& negative_pivots) {
        if (n == Blocks::tile) return Blocks::invert_tile(A, negative_pivots);
        return Blocks::template call_with_rows<Blocks::tile - 1>(
            n, [&]<int Size>() { return Blocks::template invert_tile<Size>(A, negative_pivots); });
    }
    // Computes B ← A B for a tile or less.
    static void multiply(int n, std::int64_t columns, const View& A, const Target& B) {
        if (n == Blocks::tile) return Blocks::multiply_tile(A, view(B), B, static_cast<int>(columns));
        Blocks::template call_with_rows<Blocks::tile - 1>(n, [&]<int Size>() {
            Blocks::template multiply_tile<Size>(A, view(B), B, static_cast<int>(columns));
        });
    }
};

}  // namespace gxrod
