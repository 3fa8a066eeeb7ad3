#pragma once

#include "integrators/integrator.hpp"
#include "integrators/newmark.hpp"

namespace gxrod {

// Scheme (S), the simplified Newmark scheme for finite rotations (Rubin 2007, (4.7)): the vector update with
// w = θ/Δt (4.4) applied to spatial angular velocities. Second order for γ = ½.
class NewmarkSimplified : public Integrator {
  public:
    explicit NewmarkSimplified(const Newmark& newmark) : newmark_(newmark) {}

    bool has_paper_tangent() const override { return true; }
    double contact_weight() const override { return newmark_.contact_weight(); }
    void split_impulses(State& state, const Stage&, std::vector<Vec6>& shocked) const override {
        newmark_.split_impulses(state, shocked);
    }
    bool has_transposed_rates() const override { return true; }
    void transpose_rates(const State& state,
                         double time_step,
                         const MotionGradient& rates,
                         MotionGradient& trial,
                         MotionGradient& previous) const override;
    int error_order() const override { return 3; }
    StepError estimate_error(const State& state,
                             double time_step,
                             const NodeLengths& lengths) const override {
        return estimate_newmark_error(
            {newmark_.beta - 1.0 / 6.0, 1.0 / 12.0, newmark_.gamma - 0.5}, state, time_step, lengths);
    }

  protected:
    void place_nodes(State& state, const Stage& stage, NodeRange nodes) const override;
    void update_nodes(State& state, const Stage& stage, NodeRange nodes) const override;
    void linearize_nodes(const State& state,
                         const Stage& stage,
                         NodeRange nodes,
                         std::vector<NodeLinearization>& linearizations) const override;
    void linearize_nodes_as_paper(const State& state,
                                  const Stage& stage,
                                  NodeRange nodes,
                                  std::vector<NodeLinearization>& linearizations) const override;

  private:
    Newmark newmark_;
};

}  // namespace gxrod
