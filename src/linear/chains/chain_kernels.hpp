#pragma once

#include <cstdint>

#include "machine/instruction_set.hpp"

// The sweeps of ChainSolver over its steps. Blocks are dense, column by column.
namespace gxrod {

// The size of an element of the highest order to which nothing else is coupled.
constexpr int largest_chain_block = 30;

// The place of a block of the matrix: among the given values, or among the working blocks.
struct BlockPlace {
    std::int64_t first;
    std::int32_t stride;  // from column to column
    bool is_given;
};

// A copy of a block of the given values that steps change.
struct BlockCopy {
    std::int64_t from;  // −1: it is zero
    std::int64_t to;
    std::int32_t stride;  // stride of the source
    std::int32_t rows, columns;
};

// The coupling of the block t of a step to a remaining neighbour u.
struct ChainCoupling {
    std::int64_t to;  // D_t⁻¹ A_tu
    std::int64_t diagonal;
    BlockPlace row, column;  // A_tu and A_ut
    std::int32_t first;      // first unknown of the neighbour
    std::int32_t size;
    std::int32_t apart;  // where substitution adds for the neighbour, if apart from it; −1: to the unknowns
};

struct ChainStep {
    std::int64_t diagonal;
    std::int64_t across, back;  // A_uv and A_vu of two neighbours
    std::int32_t first;         // unknown
    std::int32_t size;
    std::int32_t couplings;  // 0 to 2, after those of the steps before
    std::int32_t copies;     // copies to make before it
};

// Consecutive rows in consecutive columns.
struct EntryRun {
    std::int64_t first;  // index among the values
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

// Kernels for each instruction set; all give the same bits.
struct ChainKernels {
    // Makes the copies, factorizes each D_t and eliminates it: A_uv ← A_uv − A_ut D_t⁻¹ A_tv. Returns false
    // if a pivot vanishes. Adds the number of negative pivots.
    bool (*eliminate)(const ChainSteps& chain,
                      const double* values,
                      double* blocks,
                      std::int64_t& negative_pivots);
    // Computes x_t ← D_t⁻¹ x_t, x_u ← x_u − A_ut x_t, step by step; x_u may be in `apart`.
    void (*go_forward)(
        const ChainSteps& chain, const double* values, const double* blocks, double* x, double* apart);
    // Computes x_t ← x_t − D_t⁻¹ A_tu x_u, from the last step to the first.
    void (*go_backward)(const ChainSteps& chain, const double* blocks, double* x);
    // Computes y ← y − A x and magnitudes ← magnitudes + |A| |x|.
    void (*subtract)(const EntryRun* runs,
                     std::int64_t count,
                     const double* values,
                     const double* x,
                     double* y,
                     double* magnitudes);
};

ChainKernels find_chain_kernels(InstructionSet set);

// Each is there if its set is built (machine/built_sets.hpp).
ChainKernels make_chain_kernels_baseline();
ChainKernels make_chain_kernels_avx2();
ChainKernels make_chain_kernels_avx512();

}  // namespace gxrod
