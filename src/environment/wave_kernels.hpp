#pragma once

#include <cstddef>

#include "machine/instruction_set.hpp"

// Sums over trains of waves, several trains at once. For a train with the wave number k, ω, a, direction h =
// (cos θ, sin θ) at a place (x, y) and a height z from still water, ψ = k h·(x, y) − (ω t − φ) is the phase,
// and
//   C = e^{kz} + D e^{−kz},  S = e^{kz} − D e^{−kz},  D = e^{−2kd}, 0 in deep water.
namespace gxrod {

// The number of trains in a group; rows are padded to whole groups by trains without amplitude. Each of four
// partial sums has its own trains, whatever the instruction set.
constexpr std::size_t wave_group = 4;

// Rows with an entry for each train.
struct WaveRows {
    const double* number;     // k
    const double* frequency;  // ω
    const double* lag;        // ω t − φ
    const double* cosine;     // components of the direction
    const double* sine;
    const double* amplitude;  // a
    const double* flow;       // aω/(1 − D)
    const double* echo;       // D
};

// Sums along the common direction of all trains; a place is then (h·(x, y), 0).
struct SumsAlong {
    static constexpr int surface = 2;  // Σ a cos ψ; Σ a k sin ψ
    // With q = aω/(1 − D): Σ q C cos ψ, q S sin ψ, qω C sin ψ, qω S cos ψ, qk C sin ψ, qk S cos ψ, qωk C cos
    // ψ, qωk S sin ψ.
    static constexpr int flow = 8;
};
// Sums over trains of any direction, with the components of h, or of h⊗h: xx, xy, yy.
struct SumsInPlane {
    static constexpr int surface = 3;  // Σ a cos ψ; Σ a k sin ψ h
    // Σ q C cos ψ h, q S sin ψ, qω C sin ψ h, qω S cos ψ, qk C sin ψ h⊗h, qk S cos ψ h, qωk C cos ψ h⊗h,
    // qωk S sin ψ h.
    static constexpr int flow = 16;
};
constexpr int most_wave_sums = 16;

// Kernels for sums; each sum consists of four partial sums, one after another.
struct WaveKernels {
    // Sums over `count` trains, a multiple of wave_group. `phases`: cos ψ and sin ψ, a row each, in groups:
    // four cosines, four sines.
    using Surface =
        void (*)(const WaveRows& rows, std::size_t count, const double* place, double* phases, double* sums);
    struct Trains {
        std::size_t begin, end;  // multiples of wave_group
    };
    // Adds to the sums.
    using Flow =
        void (*)(const WaveRows& rows, const Trains& trains, double z, const double* phases, double* sums);
    struct OfDirections {
        Surface sum_surface;
        Flow add_flow;
        Flow add_deep_flow;  // without D
    };
    OfDirections along, in_plane;
};

WaveKernels make_wave_kernels_baseline();
WaveKernels make_wave_kernels_avx2();

// Returns kernels for the instruction set; all sets give the same bits.
WaveKernels find_wave_kernels(InstructionSet set);

}  // namespace gxrod
