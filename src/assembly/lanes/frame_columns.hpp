#pragma once

#include <array>

#include "assembly/state_matrices.hpp"
#include "model/settings/turning_frame.hpp"

namespace gxrod {

// Adds the terms of a frame that turns steadily with Ω to the matrices about a state that turns with it.
// Motions relative to the frame, δr = R ρ and δφ = R ψ, have δv = Ω × ρ + ρ′, δa = Ω × (Ω × ρ) + 2 Ω × ρ′ +
// ρ″, δω = ψ′, δα = Ω × ψ′ + ψ″ (docs/theory/vibrations.md, (V17)). Velocities of held components matter too,
// so the columns come from the model without supports. The system's model and team must outlive it.
class FrameColumns {
  public:
    FrameColumns(const System& system, TurningFrame frame);

    const TurningFrame& frame() const { return frame_; }
    // Computes the matrices of motions relative to the frame, with its spin at `time`.
    StateMatrices compute_matrices(const State& state, double time) const;
    // Adds to the stiffness at unchanged spatial rates the terms that make it the stiffness in the frame.
    void add_stiffness(const State& state, double time, std::vector<double>& values) const;

  private:
    struct Pair {
        int row_node, column_node;
        std::int64_t first, stride;          // among the values without supports
        std::array<std::int64_t, 36> slots;  // slots in the system; −1 where held
    };
    void add_columns(const State& state,
                     double time,
                     std::vector<double>& stiffness,
                     std::vector<double>* damping) const;

    const System* system_;
    TurningFrame frame_;
    Model model_;
    System free_;
    std::vector<Pair> pairs_;
};

// Returns the model without supports, and not kept in a plane.
Model without_supports(const Model& model);

}  // namespace gxrod
