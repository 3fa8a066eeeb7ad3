#pragma once

#include <cstdint>
#include <utility>

#include "linear/chains/chain_kernels.hpp"

// Arithmetic of small dense blocks, for sources that are compiled for one instruction set: `Arch` puts its
// name into the name of each function. Columns lie `stride` apart. Blocks are divided into tiles of a node's
// six unknowns; the last tile is smaller if other unknowns are attached to the node or a support holds some.
// The operations on an entry are the same in all sets, and so are the bits.
namespace gxrod {

using EightNumbers = double __attribute__((vector_size(64), aligned(8), may_alias));
using FourNumbers = double __attribute__((vector_size(32), aligned(8), may_alias));
using TwoNumbers = double __attribute__((vector_size(16), aligned(8), may_alias));

template <class Arch>
struct BlockKernels {
    static constexpr int tile = 6;

    // A piece of a column.
#ifdef __AVX512DQ__
    template <int Rows>
    struct Column {
        static constexpr int eights = (Rows + 7) / 8;
        __m512d eight[eights];

        // A node's six values are read and written as four and two: a load must lie within one store, or it
        // waits until that is in the cache.
        static constexpr __mmask8 mask(int count) { return static_cast<__mmask8>((1 << count) - 1); }
        static __m512d read(const double* p, int count) {
            if (count >= 8) return _mm512_loadu_pd(p);
            if (count != tile) return _mm512_maskz_loadu_pd(mask(count), p);
            return _mm512_insertf64x2(_mm512_zextpd256_pd512(_mm256_loadu_pd(p)), _mm_loadu_pd(p + 4), 2);
        }
        static void write(double* p, int count, const __m512d& numbers) {
            if (count >= 8) return _mm512_storeu_pd(p, numbers);
            if (count != tile) return _mm512_mask_storeu_pd(p, mask(count), numbers);
            _mm256_storeu_pd(p, _mm512_castpd512_pd256(numbers));
            _mm_storeu_pd(p + 4, _mm512_extractf64x2_pd(numbers, 2));
        }
        void load(const double* p) {
            for (int i = 0; i < eights; ++i) eight[i] = read(p + 8 * i, Rows - 8 * i);
        }
        void store(double* p) const {
            for (int i = 0; i < eights; ++i) write(p + 8 * i, Rows - 8 * i, eight[i]);
        }
        void set_product(const Column& a, double b) {
            for (int i = 0; i < eights; ++i) eight[i] = a.eight[i] * b;
        }
        void add(const Column& a, double b) {
            for (int i = 0; i < eights; ++i) eight[i] += a.eight[i] * b;
        }
        void subtract(const Column& a, double b) {
            for (int i = 0; i < eights; ++i) eight[i] -= a.eight[i] * b;
        }
        template <int Row>
        double get() const {
            return eight[0][Row];
        }
        template <int K>
        void eliminate(const Column& pivot, double reciprocal) {
            const __m512d factor = _mm512_set1_pd(get<K>()) * reciprocal;
            eight[0] = _mm512_mask_sub_pd(factor, 255 - (1 << K), eight[0], pivot.eight[0] * factor);
        }
        template <int K>
        void scale(double reciprocal) {
            eight[0] = _mm512_mask_mul_pd(
                _mm512_set1_pd(reciprocal), 255 - (1 << K), eight[0], _mm512_set1_pd(-reciprocal));
        }
    };
#else
    template <int Rows>
    struct Column {
        static constexpr int fours = Rows / 4;
        static constexpr bool has_two = Rows % 4 >= 2;
        static constexpr bool has_one = Rows % 2 == 1;
        FourNumbers four[fours > 0 ? fours : 1];
        TwoNumbers two;
        double one;

        void load(const double* p) {
            for (int i = 0; i < fours; ++i) four[i] = *reinterpret_cast<const FourNumbers*>(p + 4 * i);
            if constexpr (has_two) two = *reinterpret_cast<const TwoNumbers*>(p + 4 * fours);
            if constexpr (has_one) one = p[Rows - 1];
        }
        void store(double* p) const {
            for (int i = 0; i < fours; ++i) *reinterpret_cast<FourNumbers*>(p + 4 * i) = four[i];
            if constexpr (has_two) *reinterpret_cast<TwoNumbers*>(p + 4 * fours) = two;
            if constexpr (has_one) p[Rows - 1] = one;
        }
        void set_product(const Column& a, double b) {
            for (int i = 0; i < fours; ++i) four[i] = a.four[i] * b;
            if constexpr (has_two) two = a.two * b;
            if constexpr (has_one) one = a.one * b;
        }
        void add(const Column& a, double b) {
            for (int i = 0; i < fours; ++i) four[i] += a.four[i] * b;
            if constexpr (has_two) two += a.two * b;
            if constexpr (has_one) one += a.one * b;
        }
        void subtract(const Column& a, double b) {
            for (int i = 0; i < fours; ++i) four[i] -= a.four[i] * b;
            if constexpr (has_two) two -= a.two * b;
            if constexpr (has_one) one -= a.one * b;
        }
        template <int Row>
        double get() const {
            if constexpr (Row < 4 * fours) {
                return four[Row / 4][Row % 4];
            } else if constexpr (has_one && Row == Rows - 1) {
                return one;
            } else {
                return two[Row - 4 * fours];
            }
        }
        template <int Row>
        void set(double value) {
            if constexpr (Row < 4 * fours) {
                four[Row / 4][Row % 4] = value;
            } else if constexpr (has_one && Row == Rows - 1) {
                one = value;
            } else {
                two[Row - 4 * fours] = value;
            }
        }
        // Subtracts the pivot's column times the factor that clears row K, and stores the factor there.
        template <int K>
        void eliminate(const Column& pivot, double reciprocal) {
            const double factor = get<K>() * reciprocal;
            subtract(pivot, factor);
            set<K>(factor);
        }
        template <int K>
        void scale(double reciprocal) {
            set_product(*this, -reciprocal);
            set<K>(reciprocal);
        }
    };
#endif

    // A block and the distance of its columns.
    struct View {
        const double* entries;
        std::int64_t stride;
    };
    struct Target {
        double* entries;
        std::int64_t stride;
    };

    // Calls work<Rows>() with the given number, or with Most if there are more.
    template <int Most, class Work>
    static auto call_with_rows(int rows, Work&& work) {
        if constexpr (Most > 1) {
            if (rows < Most) return call_with_rows<Most - 1>(rows, work);
        }
        return work.template operator()<Most>();
    }

    // Eliminates a pivot and counts it if it is negative: for A = Aᵀ these count the negative eigenvalues
    // (Sylvester 1852).
    template <int K, int Size>
    static bool eliminate_pivot(Column<Size>* d, std::int64_t& negative_pivots) {
        const double pivot = d[K].template get<K>();
        if (pivot == 0.0) return false;
        negative_pivots += pivot < 0.0;
        const double reciprocal = 1.0 / pivot;
        for (int j = 0; j < Size; ++j) {
            if (j == K) continue;
            d[j].template eliminate<K>(d[K], reciprocal);
        }
        d[K].template scale<K>(reciprocal);
        return true;
    }

    // Computes D ← D⁻¹ for a tile, by Gauss-Jordan without pivoting. Returns false if a pivot vanishes.
    template <int Size = tile>
    static bool invert_tile(const Target& D, std::int64_t& negative_pivots) {
        Column<Size> d[Size];
        for (int j = 0; j < Size; ++j) d[j].load(D.entries + j * D.stride);
        const auto eliminate_all = [&]<int... K>(std::integer_sequence<int, K...>) {
            return (eliminate_pivot<K>(d, negative_pivots) && ...);
        };
        if (!eliminate_all(std::make_integer_sequence<int, Size>{})) return false;
        for (int j = 0; j < Size; ++j) d[j].store(D.entries + j * D.stride);
        return true;
    }

    // Computes C ← A B for a tile A and as many rows of B. C may be B.
    template <int Size = tile>
    static void multiply_tile(const View& A, const View& B, const Target& C, int columns) {
        Column<Size> a[Size];
        for (int k = 0; k < Size; ++k) a[k].load(A.entries + k * A.stride);
        for (int j = 0; j < columns; ++j) {
            const double* b = B.entries + j * B.stride;
            Column<Size> c;
            c.set_product(a[0], b[0]);
            for (int k = 1; k < Size; ++k) c.add(a[k], b[k]);
            c.store(C.entries + j * C.stride);
        }
    }

    // Computes C ← C − A B for A of Rows × 6 and B of six rows. C must not overlap A or B.
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

    // Computes C ← C − A B for p × n and n × m. C must not overlap A or B.
    static void subtract_product(int p, int n, int m, const View& A, const View& B, const Target& C) {
        if (p % tile == 0 && n % tile == 0 && p <= 4 * tile) {
            for (int k = 0; k < n; k += tile)
                subtract_tiles(p, {A.entries + k * A.stride, A.stride}, {B.entries + k, B.stride}, C, m);
            return;
        }
        subtract_any(p, n, m, A, B, C);
    }

    // Computes the same for incomplete tiles.
    static void subtract_any(int p, int n, int m, const View& A, const View& B, const Target& C) {
        constexpr int most = 2 * tile;
        for (int first = 0; first < p; first += most) {
            call_with_rows<most>(p - first, [&]<int Rows>() {
                for (int j = 0; j < m; ++j) {
                    const double* b = B.entries + j * B.stride;
                    Column<Rows> a, c;
                    c.load(C.entries + j * C.stride + first);
                    for (int k = 0; k < n; ++k) {
                        a.load(A.entries + k * A.stride + first);
                        c.subtract(a, b[k]);
                    }
                    c.store(C.entries + j * C.stride + first);
                }
            });
        }
    }

    // Factorizes D = L U of n × n in place, in tiles; the diagonal has the inverses of L's tiles, the
    // diagonal tiles of U are 1. Returns false if a pivot vanishes.
    static bool factorize(int n, double* D, std::int64_t& negative_pivots) {
        const bool is_whole = n % tile == 0;
        for (int p = 0; p < n; p += tile) {
            double* pivot = D + p * n + p;
            const int below = n - p - tile;
            if (below < 0)
                return call_with_rows<tile - 1>(n - p, [&]<int Size>() {
                    return invert_tile<Size>({pivot, n}, negative_pivots);
                });
            if (!invert_tile({pivot, n}, negative_pivots)) return false;
            if (below == 0) break;
            double* right = pivot + tile * n;
            multiply_tile({pivot, n}, {right, n}, {right, n}, below);
            const View L{pivot + tile, n}, U{right, n};
            const Target rest{right + tile, n};
            is_whole ? subtract_tiles(below, L, U, rest, below)
                     : subtract_any(below, tile, below, L, U, rest);
        }
        return true;
    }

    // Computes X ← D⁻¹ B of n × m from the result of factorize. X has no gaps; it may be B.
    static void solve(int n, int m, const double* D, const View& B, double* X) {
        if (n == tile) return multiply_tile({D, n}, B, {X, n}, m);
        if (B.entries != X) copy(n, m, B, X);
        if (n % tile != 0) return solve_any(n, m, D, X);
        for (int p = 0; p < n; p += tile) {
            const double* pivot = D + p * n + p;
            multiply_tile({pivot, n}, {X + p, n}, {X + p, n}, m);
            subtract_tiles(n - p - tile, {pivot + tile, n}, {X + p, n}, {X + p + tile, n}, m);
        }
        for (int p = n - tile; p > 0; p -= tile) subtract_tiles(p, {D + p * n, n}, {X + p, n}, {X, n}, m);
    }

    // Computes the same in place if the last tile is incomplete.
    static void solve_any(int n, int m, const double* D, double* X) {
        const int last = n / tile * tile;
        for (int p = 0; p < last; p += tile) {
            const double* pivot = D + p * n + p;
            multiply_tile({pivot, n}, {X + p, n}, {X + p, n}, m);
            subtract_any(n - p - tile, tile, m, {pivot + tile, n}, {X + p, n}, {X + p + tile, n});
        }
        call_with_rows<tile - 1>(n - last, [&]<int Size>() {
            multiply_tile<Size>({D + last * n + last, n}, {X + last, n}, {X + last, n}, m);
        });
        subtract_any(last, n - last, m, {D + last * n, n}, {X + last, n}, {X, n});
        for (int p = last - tile; p > 0; p -= tile) subtract_tiles(p, {D + p * n, n}, {X + p, n}, {X, n}, m);
    }

    // Copies without gaps.
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
