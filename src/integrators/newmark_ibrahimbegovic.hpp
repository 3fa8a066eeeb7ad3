#pragma once

#include "integrators/integrator.hpp"
#include "integrators/newmark.hpp"

namespace gxrod {

// Scheme (I), Ibrahimbegovic's Newmark scheme (Rubin 2007, (4.3)): the same update as (S) in the frame of the
// last step, then turned with the body by Λ(θ).
class NewmarkIbrahimbegovic : public Integrator {
  public:
    explicit NewmarkIbrahimbegovic(const Newmark& newmark) : newmark_(newmark) {}
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
            {newmark_.beta - 1.0 / 6.0, 1.0 / 12.0 - newmark_.beta, newmark_.gamma - 0.5},
            state,
            time_step,
            lengths);
    }

  protected:
    void place_nodes(State& state, const Stage& stage, NodeRange nodes) const override;
    void update_nodes(State& state, const Stage& stage, NodeRange nodes) const override;
    void linearize_nodes(const State& state,
                         const Stage& stage,
                         NodeRange nodes,
                         std::vector<NodeLinearization>& linearizations) const override;

  private:
    Newmark newmark_;
};

}  // namespace gxrod
