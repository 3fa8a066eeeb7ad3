#pragma once

#include <cstdint>

#include "machine/instruction_set.hpp"

// The sweeps of ChainSolver over its steps. Blocks are dense, column by column.
namespace gxrod {

// As an element of the highest order that nothing else is tied to.
constexpr int largest_chain_block = 30;

// Where a block of the matrix is: among the values that were given, or among the blocks that are worked on.
struct BlockPlace {
    std::int64_t first;
    std::int32_t stride;  // from column to column
    bool is_given;
};

// A block of the given values that steps change, and where they do so.
struct BlockCopy {
    std::int64_t from;  // −1: it is zero
    std::int64_t to;
    std::int32_t stride;  // where it comes from
    std::int32_t rows, columns;
};

// How the block t of a step is coupled to a neighbour u that remains.
struct ChainCoupling {
    std::int64_t to;  // D_t⁻¹ A_tu
    std::int64_t diagonal;
    BlockPlace row, column;  // A_tu and A_ut
    std::int32_t first;      // unknown of the neighbour
    std::int32_t size;
    std::int32_t apart;  // where substitution adds to the neighbour, if apart from it; −1: to the unknowns
};

struct ChainStep {
    std::int64_t diagonal;
    std::int64_t across, back;  // A_uv and A_vu of two neighbours
    std::int32_t first;         // unknown
    std::int32_t size;
    std::int32_t couplings;  // 0 to 2, behind those of the steps before
    std::int32_t copies;     // to be made before it
};

// Rows that follow each other in columns that do so, too.
struct EntryRun {
    std::int64_t first;  // entry among the values
    std::int32_t stride;
    std::int32_t row, column;
    std::int32_t rows, columns;
};

// Steps of one task.
struct ChainSteps {
    const ChainStep* steps;
    std::int64_t count;
    const ChainCoupling* couplings;
    std::int64_t coupling_count;
    const BlockCopy* copies;
};

// Compiled for each instruction set; all give the same bits.
struct ChainKernels {
    // Makes the copies, factorizes each D_t and eliminates it: A_uv ← A_uv − A_ut D_t⁻¹ A_tv. False if a
    // pivot vanishes. Adds the number of negative pivots.
    bool (*eliminate)(const ChainSteps& chain,
                      const double* values,
                      double* blocks,
                      std::int64_t& negative_pivots);
    // x_t ← D_t⁻¹ x_t, x_u ← x_u − A_ut x_t, step by step; or of an x_u apart.
    void (*go_forward)(
        const ChainSteps& chain, const double* values, const double* blocks, double* x, double* apart);
    // x_t ← x_t − D_t⁻¹ A_tu x_u, from the last step to the first.
    void (*go_backward)(const ChainSteps& chain, const double* blocks, double* x);
    // y ← y − A x and magnitudes ← magnitudes + |A| |x|.
    void (*subtract)(const EntryRun* runs,
                     std::int64_t count,
                     const double* values,
                     const double* x,
                     double* y,
                     double* magnitudes);
};

ChainKernels find_chain_kernels(InstructionSet set);

// By instruction set; where the compiler has no such set, those of the next narrower one.
ChainKernels make_chain_kernels_baseline();
ChainKernels make_chain_kernels_avx2();
ChainKernels make_chain_kernels_avx512();

}  // namespace gxrod
