#pragma once

#include <cstdint>

#include "linear/chains/chain_kernels.hpp"

// Arithmetic of small dense blocks, for sources that are compiled for one instruction set: `Arch` puts its
// name into that of each function. Columns lie `stride` apart. Blocks whose sizes are multiples of a node's
// six unknowns are worked on in tiles of 6 × 6. The operations on an entry are the same in all sets, and so
// are the bits.
namespace gxrod {

using FourNumbers = double __attribute__((vector_size(32), aligned(8), may_alias));
using TwoNumbers = double __attribute__((vector_size(16), aligned(8), may_alias));

template <class Arch>
struct BlockKernels {
    static constexpr int tile = 6;

    // A piece of a column with an even number of rows.
    template <int Rows>
    struct Column {
        static constexpr int fours = Rows / 4;
        static constexpr bool has_two = Rows % 4 == 2;
        FourNumbers four[fours];
        TwoNumbers two;

        void load(const double* p) {
            for (int i = 0; i < fours; ++i) four[i] = *reinterpret_cast<const FourNumbers*>(p + 4 * i);
            if constexpr (has_two) two = *reinterpret_cast<const TwoNumbers*>(p + 4 * fours);
        }
        void store(double* p) const {
            for (int i = 0; i < fours; ++i) *reinterpret_cast<FourNumbers*>(p + 4 * i) = four[i];
            if constexpr (has_two) *reinterpret_cast<TwoNumbers*>(p + 4 * fours) = two;
        }
        void set_product(const Column& a, double b) {
            for (int i = 0; i < fours; ++i) four[i] = a.four[i] * b;
            if constexpr (has_two) two = a.two * b;
        }
        void add(const Column& a, double b) {
            for (int i = 0; i < fours; ++i) four[i] += a.four[i] * b;
            if constexpr (has_two) two += a.two * b;
        }
        void subtract(const Column& a, double b) {
            for (int i = 0; i < fours; ++i) four[i] -= a.four[i] * b;
            if constexpr (has_two) two -= a.two * b;
        }
        template <int Row>
        double get() const {
            if constexpr (Row < 4 * fours) {
                return four[Row / 4][Row % 4];
            } else {
                return two[Row - 4 * fours];
            }
        }
        template <int Row>
        void set(double value) {
            if constexpr (Row < 4 * fours) {
                four[Row / 4][Row % 4] = value;
            } else {
                two[Row - 4 * fours] = value;
            }
        }
    };

    // A block and the distance of its columns.
    struct View {
        const double* entries;
        std::int64_t stride;
    };
    struct Target {
        double* entries;
        std::int64_t stride;
    };

    // Counts the pivot if it is negative: where A = Aᵀ these count the negative eigenvalues (Sylvester 1852).
    template <int K>
    static bool eliminate_pivot(Column<tile>* d, std::int64_t& negative_pivots) {
        const double pivot = d[K].template get<K>();
        if (pivot == 0.0) return false;
        negative_pivots += pivot < 0.0;
        const double reciprocal = 1.0 / pivot;
        for (int j = 0; j < tile; ++j) {
            if (j == K) continue;
            const double factor = d[j].template get<K>() * reciprocal;
            d[j].subtract(d[K], factor);
            d[j].template set<K>(factor);
        }
        d[K].set_product(d[K], -reciprocal);
        d[K].template set<K>(reciprocal);
        return true;
    }

    // D ← D⁻¹ of a tile, by Gauss-Jordan without pivoting. False if a pivot vanishes.
    static bool invert_tile(const Target& D, std::int64_t& negative_pivots) {
        Column<tile> d[tile];
        for (int j = 0; j < tile; ++j) d[j].load(D.entries + j * D.stride);
        std::int64_t& negative = negative_pivots;
        if (!(eliminate_pivot<0>(d, negative) && eliminate_pivot<1>(d, negative) &&
              eliminate_pivot<2>(d, negative) && eliminate_pivot<3>(d, negative) &&
              eliminate_pivot<4>(d, negative) && eliminate_pivot<5>(d, negative)))
            return false;
        for (int j = 0; j < tile; ++j) d[j].store(D.entries + j * D.stride);
        return true;
    }

    // C ← A B of a tile and six rows. C may be B.
    static void multiply_tile(const View& A, const View& B, const Target& C, int columns) {
        Column<tile> a[tile];
        for (int k = 0; k < tile; ++k) a[k].load(A.entries + k * A.stride);
        for (int j = 0; j < columns; ++j) {
            const double* b = B.entries + j * B.stride;
            Column<tile> c;
            c.set_product(a[0], b[0]);
            for (int k = 1; k < tile; ++k) c.add(a[k], b[k]);
            c.store(C.entries + j * C.stride);
        }
    }

    // C ← C − A B of Rows × 6 and six rows. C is apart from both.
    template <int Rows>
    static void subtract_tiles(const View& A, const View& B, const Target& C, int columns) {
        int j = 0;
        if constexpr (Rows > tile) {
            for (; j + 1 < columns; j += 2) {
                const double* b = B.entries + j * B.stride;
                Column<Rows> c, d;
                c.load(C.entries + j * C.stride);
                d.load(C.entries + (j + 1) * C.stride);
                for (int k = 0; k < tile; ++k) {
                    Column<Rows> a;
                    a.load(A.entries + k * A.stride);
                    c.subtract(a, b[k]);
                    d.subtract(a, b[B.stride + k]);
                }
                c.store(C.entries + j * C.stride);
                d.store(C.entries + (j + 1) * C.stride);
            }
        }
        Column<Rows> a[tile];
        for (int k = 0; k < tile && j < columns; ++k) a[k].load(A.entries + k * A.stride);
        for (; j < columns; ++j) {
            const double* b = B.entries + j * B.stride;
            Column<Rows> c;
            c.load(C.entries + j * C.stride);
            for (int k = 0; k < tile; ++k) c.subtract(a[k], b[k]);
            c.store(C.entries + j * C.stride);
        }
    }
    static void subtract_tiles(int rows, const View& A, const View& B, const Target& C, int columns) {
        switch (rows / tile) {
            case 1:
                return subtract_tiles<tile>(A, B, C, columns);
            case 2:
                return subtract_tiles<2 * tile>(A, B, C, columns);
            case 3:
                return subtract_tiles<3 * tile>(A, B, C, columns);
            case 4:
                return subtract_tiles<4 * tile>(A, B, C, columns);
            default:
                return;
        }
    }

    // C ← C − A B of p × n and n × m. C is apart from both.
    static void subtract_product(int p, int n, int m, const View& A, const View& B, const Target& C) {
        if (p % tile == 0 && n % tile == 0 && p <= 4 * tile) {
            for (int k = 0; k < n; k += tile)
                subtract_tiles(p, {A.entries + k * A.stride, A.stride}, {B.entries + k, B.stride}, C, m);
            return;
        }
        for (int j = 0; j < m; ++j) {
            double* c = C.entries + j * C.stride;
            for (int k = 0; k < n; ++k) {
                const double factor = B.entries[j * B.stride + k];
                for (int i = 0; i < p; ++i) c[i] -= A.entries[k * A.stride + i] * factor;
            }
        }
    }

    // As invert_tile.
    static bool invert_any(int n, double* D, std::int64_t& negative_pivots) {
        for (int k = 0; k < n; ++k) {
            double* pivot_column = D + k * n;
            if (pivot_column[k] == 0.0) return false;
            negative_pivots += pivot_column[k] < 0.0;
            const double reciprocal = 1.0 / pivot_column[k];
            for (int j = 0; j < n; ++j) {
                if (j == k) continue;
                double* column = D + j * n;
                const double factor = column[k] * reciprocal;
                for (int i = 0; i < n; ++i) column[i] -= factor * pivot_column[i];
                column[k] = factor;
            }
            for (int i = 0; i < n; ++i) pivot_column[i] *= -reciprocal;
            pivot_column[k] = reciprocal;
        }
        return true;
    }

    // D ← L and U of n × n with D = L U, in tiles; on the diagonal the inverses of L's tiles, those of U are
    // 1. D⁻¹ if there are no whole tiles. False if a pivot vanishes.
    static bool factorize(int n, double* D, std::int64_t& negative_pivots) {
        if (n % tile != 0) return invert_any(n, D, negative_pivots);
        for (int p = 0; p < n; p += tile) {
            double* pivot = D + p * n + p;
            const int below = n - p - tile;
            if (!invert_tile({pivot, n}, negative_pivots)) return false;
            if (below == 0) break;
            double* right = pivot + tile * n;
            multiply_tile({pivot, n}, {right, n}, {right, n}, below);
            subtract_tiles(below, {pivot + tile, n}, {right, n}, {right + tile, n}, below);
        }
        return true;
    }

    // X ← D⁻¹ B of n × m, with what factorize made of D. X has no gaps; it may be B.
    static void solve(int n, int m, const double* D, const View& B, double* X) {
        if (n == tile) return multiply_tile({D, n}, B, {X, n}, m);
        if (n % tile != 0) return multiply_any(n, m, D, B, X);
        if (B.entries != X) copy(n, m, B, X);
        for (int p = 0; p < n; p += tile) {
            const double* pivot = D + p * n + p;
            multiply_tile({pivot, n}, {X + p, n}, {X + p, n}, m);
            subtract_tiles(n - p - tile, {pivot + tile, n}, {X + p, n}, {X + p + tile, n}, m);
        }
        for (int p = n - tile; p > 0; p -= tile) subtract_tiles(p, {D + p * n, n}, {X + p, n}, {X, n}, m);
    }

    static void multiply_any(int n, int m, const double* A, const View& B, double* C) {
        double b[largest_chain_block];
        for (int j = 0; j < m; ++j) {
            for (int i = 0; i < n; ++i) b[i] = B.entries[j * B.stride + i];
            double* c = C + j * n;
            for (int i = 0; i < n; ++i) c[i] = 0.0;
            for (int k = 0; k < n; ++k) {
                for (int i = 0; i < n; ++i) c[i] += A[k * n + i] * b[k];
            }
        }
    }

    // Leaves no gaps.
    static void copy(int rows, int columns, const View& from, double* to) {
        for (int j = 0; j < columns; ++j) {
            const double* column = from.entries + j * from.stride;
            int i = 0;
            for (; i + 6 <= rows; i += 6) {
                Column<tile> piece;
                piece.load(column + i);
                piece.store(to + j * rows + i);
            }
            for (; i < rows; ++i) to[j * rows + i] = column[i];
        }
    }
};

}  // namespace gxrod
