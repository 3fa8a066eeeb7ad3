#pragma once

#include <cstdint>
#include <tuple>

#include "machine/instruction_set.hpp"

// Kernels that work on several elements or nodes at once, a lane each. Unless noted otherwise, what they
// read and write are rows with an entry for each of `width` lanes; quaternions are x, y, z, w, matrices
// column by column.
namespace gxrod {

constexpr int most_lanes = 8;

// Where a block of 6 × 6 of one lane goes: its first entry, and from column to column.
struct LaneBlock {
    double* first;
    std::int64_t stride;
};

// Elements `objective`, and the inertia and mass-proportional damping of their centres of mass. Kernels for
// plain sections have no damping, and their centre of mass lies at the nodes. What is known of sections lies
// in one place, so that elements of one section share it.
template <int Nodes>
struct RodKernels {
    static constexpr int point_count = Nodes - 1;
    // One entry each, all lanes alike: whether a centre of mass lies off its node, 1 or 0; the factors of
    // Kelvin-Voigt and of mass-proportional damping; with more than two nodes the weights of the quadrature,
    // shape functions at each point, and their slopes dN_I/dξ.
    static constexpr int shared_rows = 3 + (Nodes > 2 ? point_count * (1 + 2 * Nodes) : 0);
    // Behind them: of each point the blocks C_NN, C_NM, C_MM of the stiffness; of each node the centre of
    // mass from there, material.
    static constexpr int section_rows = 27 * point_count + 3 * Nodes;
    // Of each point ds/dξ (of two nodes: the length), Γ₀, K₀; triads of the nodes; masses ∫ρA N_I N_J ds, J ≥
    // I.
    static constexpr int constant_rows = 7 * point_count + 4 * Nodes + Nodes * (Nodes + 1) / 2;
    // Λ_I; r_I − r of the first node, of the others; accelerations less gravity.
    static constexpr int plain_motion_rows = 10 * Nodes - 3;
    // These; ω; α; v.
    static constexpr int motion_rows = plain_motion_rows + 9 * Nodes;
    // Force and moment of each node, then the largest component of a force and of a moment, be they of
    // stiffness and damping or of inertia.
    static constexpr int force_rows = 6 * Nodes + 2;
    // Λ_I, r_I − r of the first node; `placement`, then `acceleration` of the linearizations.
    static constexpr int plain_linearization_rows = 9 * Nodes - 3;
    // These; accelerations less gravity; ω; α; v; `rate`; d_omega; d_alpha.
    static constexpr int linearization_rows = plain_linearization_rows + 31 * Nodes;
    static constexpr int tangent_rows = 36 * Nodes * Nodes;

    // False, with no result, if a node is turned too far for a kernel from the frame of its element.
    using Kernel = bool (*)(const double* section,
                            const double* constants,
                            const double* motions,
                            double* results);
    struct OfSections {
        Kernel compute_forces;
        Kernel compute_tangents;
    };
    OfSections plain, general;
    // From the motion and to the force rows of any section, of damping alone.
    Kernel compute_damping_forces;
    // Adds the tangents to the blocks of each pair of nodes, column by column, of each lane.
    void (*add_tangents)(const double* tangents, const LaneBlock* blocks);
};

// Rotary inertia of nodes (rotary_inertia.hpp), or its momentum in place of the inertial moment.
struct RotaryKernels {
    // J₀.
    static constexpr int constant_rows = 9;
    // Λ, ω, α.
    static constexpr int motion_rows = 10;
    static constexpr int moment_rows = 3;
    // These; `placement`, d_omega, d_alpha.
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
