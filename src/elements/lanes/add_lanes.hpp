#pragma once

#include "elements/lanes/kernels.hpp"

// Only for the sources of instruction sets; see lanes.hpp.
namespace gxrod {

// Adds matrices in rows, with an entry for each lane, to the matrices of single elements: four rows of four
// lanes are turned into four rows of each lane, or two of two.
template <int Nodes, class Real>
struct AddLanes {
    static constexpr int width = Real::size;
    static constexpr int together = width < 4 ? width : 4;
    using FourNumbers = double __attribute__((vector_size(32), aligned(8), may_alias));
    using TwoNumbers = double __attribute__((vector_size(16), aligned(8), may_alias));

    // These are no templates of the number type, which would lose its alignment.
    static FourNumbers load_four(const double* row) { return *reinterpret_cast<const FourNumbers*>(row); }
    static TwoNumbers load_two(const double* row) { return *reinterpret_cast<const TwoNumbers*>(row); }
    static void add_four(double* target, const FourNumbers& added) {
        *reinterpret_cast<FourNumbers*>(target) += added;
    }
    static void add_two(double* target, const TwoNumbers& added) {
        *reinterpret_cast<TwoNumbers*>(target) += added;
    }

    // Adds from the last pair of nodes to the first: an element that begins with the last node of the one
    // before adds after it.
    static void add_tangents(const double* tangents, const LaneBlock* blocks) {
        for (int pair = Nodes * Nodes - 1; pair >= 0; --pair) {
            const double* block = tangents + width * (36 * Nodes * (pair / Nodes) + 6 * (pair % Nodes));
            for (int column = 0; column < 6; ++column) {
                for (int lane = 0; lane < width; lane += together) {
                    double* targets[together];
                    for (int i = 0; i < together; ++i) {
                        const LaneBlock& to = blocks[pair * width + lane + i];
                        targets[i] = to.first + column * to.stride;
                    }
                    add_column(block + width * 6 * Nodes * column + lane, targets);
                }
            }
        }
    }

    static void add_column(const double* rows, double* const* targets) {
        if constexpr (together == 4) {
            FourNumbers row[6];
            for (int i = 0; i < 6; ++i) row[i] = load_four(rows + i * width);
            // Entries of lanes 0 and 2, and of lanes 1 and 3.
            const FourNumbers even_01 = __builtin_shufflevector(row[0], row[1], 0, 4, 2, 6);
            const FourNumbers odd_01 = __builtin_shufflevector(row[0], row[1], 1, 5, 3, 7);
            const FourNumbers even_23 = __builtin_shufflevector(row[2], row[3], 0, 4, 2, 6);
            const FourNumbers odd_23 = __builtin_shufflevector(row[2], row[3], 1, 5, 3, 7);
            const FourNumbers even_45 = __builtin_shufflevector(row[4], row[5], 0, 4, 2, 6);
            const FourNumbers odd_45 = __builtin_shufflevector(row[4], row[5], 1, 5, 3, 7);
            add_four(targets[0], __builtin_shufflevector(even_01, even_23, 0, 1, 4, 5));
            add_two(targets[0] + 4, TwoNumbers{even_45[0], even_45[1]});
            add_four(targets[1], __builtin_shufflevector(odd_01, odd_23, 0, 1, 4, 5));
            add_two(targets[1] + 4, TwoNumbers{odd_45[0], odd_45[1]});
            add_four(targets[2], __builtin_shufflevector(even_01, even_23, 2, 3, 6, 7));
            add_two(targets[2] + 4, TwoNumbers{even_45[2], even_45[3]});
            add_four(targets[3], __builtin_shufflevector(odd_01, odd_23, 2, 3, 6, 7));
            add_two(targets[3] + 4, TwoNumbers{odd_45[2], odd_45[3]});
        } else {
            for (int i = 0; i < 6; i += 2) {
                const auto a = load_two(rows + i * width), b = load_two(rows + (i + 1) * width);
                add_two(targets[0] + i, __builtin_shufflevector(a, b, 0, 2));
                add_two(targets[1] + i, __builtin_shufflevector(a, b, 1, 3));
            }
        }
    }
};

}  // namespace gxrod
