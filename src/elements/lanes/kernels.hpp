#pragma once

#include "elements/lanes/instruction_set.hpp"

// Kernels that work on several elements or nodes at once, a lane each. Except where it is said, what they
// read and write are rows with an entry for each of `width` lanes; quaternions are x, y, z, w, matrices
// column by column.
namespace gxrod {

constexpr int most_lanes = 4;

// Elements `objective` with two nodes (two_node_rod.hpp), and the consistent mass of their translation.
struct TwoNodeKernels {
    // One entry each, all lanes alike: the blocks C_NN, C_NM, C_MM of the stiffness.
    static constexpr int section_rows = 27;
    // L, Γ₀, K₀, triads of a and b, masses ∫ρA N_I N_J ds of (a, a), (a, b), (b, b).
    static constexpr int constant_rows = 18;
    // Λ of a and b, r_b − r_a, accelerations less gravity of a and b.
    static constexpr int motion_rows = 17;
    // Force and moment of a and b, then the largest component of a force and of a moment, be they of
    // stiffness or of inertia.
    static constexpr int force_rows = 14;
    // Λ of a and b, r_b − r_a; `placement` and `acceleration` of the linearizations of a and b.
    static constexpr int linearization_rows = 15;
    static constexpr int tangent_rows = 144;

    using Kernel = void (*)(const double* section,
                            const double* constants,
                            const double* motions,
                            double* results);
    Kernel compute_forces;
    Kernel compute_tangents;
};

// Rotary inertia of nodes (rotary_inertia.hpp).
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
    TwoNodeKernels two_node;
    RotaryKernels rotary;
};

Kernels find_kernels(InstructionSet set);

}  // namespace gxrod
