#pragma once

#include <array>

#include "assembly/state_matrices.hpp"
#include "model/settings/turning_frame.hpp"

namespace gxrod {

// What a frame that turns steadily with Ω adds to the matrices about a state that turns with it. Motions
// relative to the frame, δr = R ρ and δφ = R ψ, have δv = Ω × ρ + ρ′, δa = Ω × (Ω × ρ) + 2 Ω × ρ′ + ρ″, δω =
// ψ′, δα = Ω × ψ′ + ψ″ (docs/theory/vibrations.md, (V17)): velocities of held components too, so the
// columns are those of the model without supports. The system's model and team must outlive it.
class FrameColumns {
  public:
    FrameColumns(const System& system, TurningFrame frame);

    const TurningFrame& frame() const { return frame_; }
    // Of motions relative to the frame, at the spin that it has at `time`.
    StateMatrices compute_matrices(const State& state, double time) const;
    // Adds to the stiffness at unchanged spatial rates what makes it that of the frame.
    void add_stiffness(const State& state, double time, std::vector<double>& values) const;

  private:
    struct Pair {
        int row_node, column_node;
        std::int64_t first, stride;          // among the values without supports
        std::array<std::int64_t, 36> slots;  // among those of the system; −1 where held
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

// The same without supports, and not kept in a plane.
Model without_supports(const Model& model);

}  // namespace gxrod
