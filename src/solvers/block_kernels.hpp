#pragma once

// Arithmetic of small dense blocks, column by column without gaps; several sizes have code of their own.
namespace gxrod {

// D ← D⁻¹ of n × n, by Gauss-Jordan without pivoting. False if a pivot vanishes.
bool invert_block(int n, double* D);

// C ← A B of n × n and n × m. C is apart from both.
void multiply_blocks(int n, int m, const double* A, const double* B, double* C);

// C ← C − A B of p × n and n × m. C is apart from both.
void subtract_product(int p, int n, int m, const double* A, const double* B, double* C);

}  // namespace gxrod
