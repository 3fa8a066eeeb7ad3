#include "solvers/block_kernels.hpp"

#include <algorithm>
#include <cmath>

namespace gxrod {
namespace {

// Size 0 stands for one that is known at run time only.
template <int Fixed>
inline bool invert(int run_time_size, double* D) {
    const int n = Fixed > 0 ? Fixed : run_time_size;
    for (int k = 0; k < n; ++k) {
        double* pivot_column = D + k * n;
        const double pivot = pivot_column[k];
        if (pivot == 0.0) return false;
        const double reciprocal = 1.0 / pivot;
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

// C ← C ± A B.
template <int Fixed, int Sign>
inline void multiply_add(int p, int n, int m, const double* A, const double* B, double* C) {
    const int rows = Fixed > 0 ? Fixed : p;
    const int inner = Fixed > 0 ? Fixed : n;
    const int columns = Fixed > 0 && m > 1 ? Fixed : m;
    for (int j = 0; j < columns; ++j) {
        double* column = C + j * rows;
        for (int k = 0; k < inner; ++k) {
            const double factor = Sign * B[j * inner + k];
            for (int i = 0; i < rows; ++i) column[i] += factor * A[k * rows + i];
        }
    }
}

template <int Fixed>
inline void copy(const BlockView& block, double* target) {
    const int rows = Fixed > 0 ? Fixed : block.rows;
    for (int j = 0; j < block.columns; ++j) {
        const double* column = block.entries + j * block.stride;
        for (int i = 0; i < rows; ++i) target[j * rows + i] = column[i];
    }
}

template <int Fixed>
inline void subtract_and_sum(const BlockView& A, const double* x, double* y, double* magnitudes) {
    const int rows = Fixed > 0 ? Fixed : A.rows;
    for (int j = 0; j < A.columns; ++j) {
        const double* column = A.entries + j * A.stride;
        for (int i = 0; i < rows; ++i) {
            const double product = column[i] * x[j];
            y[i] -= product;
            magnitudes[i] += std::abs(product);
        }
    }
}

constexpr int node_size = 6;

}  // namespace

bool invert_block(int n, double* D) { return n == node_size ? invert<node_size>(n, D) : invert<0>(n, D); }

void multiply_blocks(int n, int m, const double* A, const double* B, double* C) {
    std::fill_n(C, n * m, 0.0);
    if (n == node_size && (m == node_size || m == 1)) {
        multiply_add<node_size, 1>(n, n, m, A, B, C);
    } else {
        multiply_add<0, 1>(n, n, m, A, B, C);
    }
}

void copy_block(const BlockView& block, double* target) {
    block.rows == node_size ? copy<node_size>(block, target) : copy<0>(block, target);
}

void subtract_with_magnitudes(const BlockView& A, const double* x, double* y, double* magnitudes) {
    A.rows == node_size ? subtract_and_sum<node_size>(A, x, y, magnitudes)
                        : subtract_and_sum<0>(A, x, y, magnitudes);
}

void subtract_product(int p, int n, int m, const double* A, const double* B, double* C) {
    if (p == node_size && n == node_size && (m == node_size || m == 1)) {
        multiply_add<node_size, -1>(p, n, m, A, B, C);
    } else {
        multiply_add<0, -1>(p, n, m, A, B, C);
    }
}

}  // namespace gxrod
