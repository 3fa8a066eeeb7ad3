#pragma once

#include <cstdint>

// Arithmetic of small dense blocks, column by column without gaps; several sizes have code of their own.
namespace gxrod {

// D ← D⁻¹ of n × n, by Gauss-Jordan without pivoting. False if a pivot vanishes.
bool invert_block(int n, double* D);

// C ← A B of n × n and n × m. C is apart from both.
void multiply_blocks(int n, int m, const double* A, const double* B, double* C);

// A block of a matrix whose columns lie `stride` apart.
struct BlockView {
    int rows, columns;
    std::int64_t stride;
    const double* entries;
};

// Copies it to where its columns lie without gaps.
void copy_block(const BlockView& block, double* target);

// y ← y − A x and magnitudes ← magnitudes + |A| |x|.
void subtract_with_magnitudes(const BlockView& A, const double* x, double* y, double* magnitudes);

// C ← C − A B of p × n and n × m. C is apart from both.
void subtract_product(int p, int n, int m, const double* A, const double* B, double* C);

}  // namespace gxrod
