#pragma once

#include "integrators/integrator.hpp"

namespace gxrod {

// The classical explicit Runge-Kutta scheme of order 4 on (r, q, v, ω), q the unit quaternion of a node's
// rotation with q̇ = ½ ω q, normalised after each step.
//
// Stage k places the motion for which rate number k + 1 is evaluated; rate 0 is the rate at the step's start,
// and the last stage is the end of the step, whose accelerations are the next step's rate 0.
class RungeKutta4 : public Integrator {
  public:
    static constexpr int stages = 4;

    int stage_count() const override { return stages; }
    double stage_fraction(int stage) const override { return stage < 2 ? 0.5 : 1.0; }
    ConstraintLevel constraint_level(int) const override { return ConstraintLevel::acceleration; }
    bool is_explicit() const override { return true; }
    std::vector<double> power_weights() const override {
        return {1.0 / 6.0, 1.0 / 3.0, 1.0 / 3.0, 1.0 / 6.0, 0.0};
    }

  protected:
    int kept_stages() const override { return stages; }
    void place_nodes(State& state, const Stage& stage, NodeRange nodes) const override;
    void update_nodes(State&, const Stage&, NodeRange) const override {}
    void linearize_nodes(const State& state,
                         const Stage& stage,
                         NodeRange nodes,
                         std::vector<NodeLinearization>& linearizations) const override;
    void finish_nodes(State& state, const Stage& stage, NodeRange nodes) const override;
};

}  // namespace gxrod
