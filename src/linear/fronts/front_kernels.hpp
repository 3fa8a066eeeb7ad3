#pragma once

#include <cstdint>

#include "machine/instruction_set.hpp"

// The sweeps of FrontSolver over its fronts. Matrices are dense, column by column.
namespace gxrod {

// A copy of given values to their place among the factors.
struct FrontCopy {
    std::int64_t from, to;
    std::int32_t from_stride, to_stride;  // from column to column
    std::int32_t rows, columns;
};

// Rows of a front after its pivots that are consecutive in the order of elimination and in the front above.
struct FrontRun {
    std::int32_t unknown;  // in the order of elimination
    std::int32_t above;    // row in the front above
    std::int32_t count;
};

// Unknowns that are eliminated together, and the later unknowns that they couple.
struct Front {
    std::int64_t lower;                   // rows × pivots: L, and U between the pivots
    std::int64_t upper;                   // pivots × (rows − pivots): the rest of U
    std::int64_t update;                  // in the stack of its level: the sum to be added to the front above
    std::int64_t runs, copies, children;  // indices of the first
    std::int32_t first;                   // first pivot in the order of elimination
    std::int32_t pivots, rows;
    std::int32_t run_count, copy_count, child_count;
    std::int32_t stack;  // 0 or 1
};

struct Fronts {
    const Front* fronts;
    std::int64_t count;
    const FrontRun* runs;
    const FrontCopy* copies;
    const std::int32_t* children;  // indices of fronts
};

// Kernels for each instruction set; all give the same bits.
struct FrontKernels {
    // Gathers one front from the values and the updates of its children, eliminates its pivots, and leaves
    // its own update in its stack. Returns false if a pivot vanishes. Adds the number of negative pivots.
    bool (*eliminate)(const Fronts& fronts,
                      std::int64_t front,
                      const double* values,
                      double* factors,
                      double* const* stacks,
                      std::int64_t& negative_pivots);
    // Computes x ← L⁻¹ x for one front; `work` has room for its rows.
    void (*go_forward)(
        const Fronts& fronts, std::int64_t front, const double* factors, double* x, double* work);
    // Computes x ← U⁻¹ x.
    void (*go_backward)(
        const Fronts& fronts, std::int64_t front, const double* factors, double* x, double* work);
};

FrontKernels find_front_kernels(InstructionSet set);

// Each is there if its set is built (machine/built_sets.hpp).
FrontKernels make_front_kernels_baseline();
FrontKernels make_front_kernels_avx2();
FrontKernels make_front_kernels_avx512();

}  // namespace gxrod
