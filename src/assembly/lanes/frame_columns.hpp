#pragma once

#include <array>
#include <memory>

#include "assembly/state_matrices.hpp"
#include "model/settings/turning_frame.hpp"

namespace gxrod {

// Adds the terms of steady rotation to the matrices about a state (docs/theory/vibrations.md).
//
// In a frame that turns with Ω, motions relative to it, δr = R ρ and δφ = R ψ, have δv = Ω × ρ + ρ′, δa = Ω ×
// (Ω × ρ) + 2 Ω × ρ′ + ρ″, δω = ψ′, δα = Ω × ψ′ + ψ″, (V17). Velocities of held components matter too, so the
// columns come from the model without supports.
//
// In a frame at rest, nodes that spin with Ω about the axes that they carry have δω = ψ′ − Ω × ψ and δα = ψ″
// − Ω × ψ′, and all nodes δv = ρ′, δa = ρ″, (V23). The system's model and team must outlive it.
class FrameColumns {
  public:
    FrameColumns(const System& system, TurningFrame frame);

    const TurningFrame& frame() const { return frame_; }
    // Computes the matrices of motions relative to the frame, with its spin at `time`.
    StateMatrices compute_matrices(const State& state, double time) const;
    // Adds to the stiffness at unchanged spatial rates the terms that make it the stiffness in the frame.
    void add_stiffness(const State& state, double time, std::vector<double>& values) const;

  private:
    // The model without supports.
    struct Free {
        Model model;
        System system;

        explicit Free(const System& held);
    };
    struct Pair {
        int row_node, column_node;
        std::int64_t first, stride;          // among the values without supports
        std::array<std::int64_t, 36> slots;  // slots in the system; −1 where held
    };
    void list_pairs();
    void add_columns(const State& state,
                     double time,
                     std::vector<double>& stiffness,
                     std::vector<double>* damping) const;
    // Computes −Ω × of each node, of a frame at rest.
    std::vector<Mat3> list_spins(const State& state, double time) const;

    const System* system_;
    TurningFrame frame_;
    std::unique_ptr<const Free> free_;  // of a frame that turns
    std::vector<Pair> pairs_;
};

// Returns the model without supports, and not kept in a plane.
Model without_supports(Model model);

}  // namespace gxrod
