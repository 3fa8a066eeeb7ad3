#include "solvers/block_kernels.hpp"

#include <algorithm>

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

void subtract_product(int p, int n, int m, const double* A, const double* B, double* C) {
    if (p == node_size && n == node_size && (m == node_size || m == 1)) {
        multiply_add<node_size, -1>(p, n, m, A, B, C);
    } else {
        multiply_add<0, -1>(p, n, m, A, B, C);
    }
}

}  // namespace gxrod
