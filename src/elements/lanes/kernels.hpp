#pragma once

#include <cstdint>
#include <tuple>

#include "machine/instruction_set.hpp"

// Kernels that work on several elements or nodes at once, one in each lane. Unless noted otherwise, they read
// and write rows with an entry for each of `width` lanes; quaternions are x, y, z, w, matrices column by
// column.
namespace gxrod {

constexpr int most_lanes = 8;

// The place of a block of 6 × 6 of one lane: its first entry, and the distance of its columns.
struct LaneBlock {
    double* first;
    std::int64_t stride;
};

// Elements `objective`, and the inertia and mass-proportional damping of their centres of mass. Kernels for
// plain sections have no damping, and their centre of mass lies at the nodes. Elements of one section share
// the rows of its constants.
template <int Nodes>
struct RodKernels {
    static constexpr int point_count = Nodes - 1;
    // One entry each, equal in all lanes: whether a centre of mass lies off its node, 1 or 0; the factors of
    // Kelvin-Voigt and of mass-proportional damping; with more than two nodes the weights of the quadrature,
    // shape functions at each point, and their slopes dN_I/dξ.
    static constexpr int shared_rows = 3 + (Nodes > 2 ? point_count * (1 + 2 * Nodes) : 0);
    // After them: for each point the blocks C_NN, C_NM, C_MM of the stiffness; for each node its centre of
    // mass, material.
    static constexpr int section_rows = 27 * point_count + 3 * Nodes;
    // For each point ds/dξ (with two nodes: the length), Γ₀, K₀; triads of the nodes; masses ∫ρA N_I N_J ds,
    // J ≥ I.
    static constexpr int constant_rows = 7 * point_count + 4 * Nodes + Nodes * (Nodes + 1) / 2;
    // Λ_I; r_I − r of the first node, for the others; accelerations less gravity.
    static constexpr int plain_motion_rows = 10 * Nodes - 3;
    // The plain rows; ω; α; v.
    static constexpr int motion_rows = plain_motion_rows + 9 * Nodes;
    // Force and moment of each node, then the largest component of a force and of a moment, from stiffness
    // and damping or from inertia.
    static constexpr int force_rows = 6 * Nodes + 2;
    // Λ_I, r_I − r of the first node; `placement`, then `acceleration` of the linearizations.
    static constexpr int plain_linearization_rows = 9 * Nodes - 3;
    // The plain rows; accelerations less gravity; ω; α; v; `rate`; d_omega; d_alpha.
    static constexpr int linearization_rows = plain_linearization_rows + 31 * Nodes;
    static constexpr int tangent_rows = 36 * Nodes * Nodes;

    // A kernel. It returns false, with no result, if a node is turned too far from the frame of its element.
    using Kernel = bool (*)(const double* section,
                            const double* constants,
                            const double* motions,
                            double* results);
    struct OfSections {
        Kernel compute_forces;
        Kernel compute_tangents;
    };
    OfSections plain, general;
    // Computes the force rows of damping alone from the motion, for any section.
    Kernel compute_damping_forces;
    // Adds the tangents to the blocks of each pair of nodes, column by column, of each lane.
    void (*add_tangents)(const double* tangents, const LaneBlock* blocks);
};

// Rotary inertia of nodes (rotary_inertia.hpp), or its momentum in place of the inertial moment.
struct RotaryKernels {
    // The matrix J₀.
    static constexpr int constant_rows = 9;
    // The rows Λ, ω, α.
    static constexpr int motion_rows = 10;
    static constexpr int moment_rows = 3;
    // The motion rows; `placement`, d_omega, d_alpha.
    static constexpr int linearization_rows = motion_rows + 19;
    static constexpr int tangent_rows = 9;

    using Kernel = void (*)(const double* constants, const double* motions, double* results);
    Kernel compute_moments;
    Kernel compute_tangents;
};

struct Kernels {
    int width;
    std::tuple<RodKernels<2>, RodKernels<3>, RodKernels<4>, RodKernels<5>> rods;
    RotaryKernels rotary;
    RotaryKernels rotary_damping;
};

Kernels find_kernels(InstructionSet set);

}  // namespace gxrod
