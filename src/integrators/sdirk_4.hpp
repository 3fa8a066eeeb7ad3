#pragma once

#include <array>

#include "integrators/integrator.hpp"

namespace gxrod {

// The L-stable diagonally implicit Runge-Kutta scheme of order 4 with five stages (Hairer & Wanner 1996,
// SDIRK4, table IV.6.5), in the rotation vector of the step: θ_i = Δt Σ_j a_ij T(θ_j)⁻¹ ω_j, ω_i = ω_n + Δt
// Σ_j a_ij α_j. The last stage is the end of the step. Each stage is an equilibrium at its own time.
class Sdirk4 : public Integrator {
  public:
    static constexpr int stages = 5;
    static constexpr double diagonal = 0.25;
    static const std::array<std::array<double, stages>, stages> a;
    // The weights of the embedded scheme of order 3; the last row of `a` has the weights of order 4.
    static const std::array<double, stages> embedded_weights;

    double contact_weight() const override { return 1.0; }
    bool resolves_contact() const override { return true; }
    int stage_count() const override { return stages; }
    double stage_fraction(int stage) const override;
    ConstraintLevel constraint_level(int stage) const override {
        return stage + 1 < stages ? ConstraintLevel::acceleration : ConstraintLevel::position;
    }
    // Estimates the error as the difference between the schemes of order 4 and 3, with the leading error term
    // of order 3.
    int error_order() const override { return 4; }
    StepError estimate_error(const State& state, double time_step, const NodeLengths& lengths) const override;
    std::vector<double> power_weights() const override;

  protected:
    int kept_stages() const override { return stages; }
    void place_nodes(State& state, const Stage& stage, NodeRange nodes) const override;
    void update_nodes(State& state, const Stage& stage, NodeRange nodes) const override;
    void linearize_nodes(const State& state,
                         const Stage& stage,
                         NodeRange nodes,
                         std::vector<NodeLinearization>& linearizations) const override;
    void finish_nodes(State& state, const Stage& stage, NodeRange nodes) const override;
};

}  // namespace gxrod
