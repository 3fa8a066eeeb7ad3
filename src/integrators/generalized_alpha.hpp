#pragma once

#include "integrators/integrator.hpp"
#include "integrators/newmark.hpp"

namespace gxrod {

// Generalized-α of Chung & Hulbert on the rotation group in the form of Arnold & Brüls (2007): equilibrium at
// the end of the step, spatial rates, and an algorithmic acceleration A per node that lags the true one: (1 −
// α_m) A + α_m A_n = (1 − α_f) α + α_f α_n. Second order; the spectral radius at infinite frequency sets the
// damping, from 1 (none) to 0.
class GeneralizedAlpha : public Integrator {
  public:
    explicit GeneralizedAlpha(double spectral_radius);

    int carried_count() const override { return 1; }
    void start(State& state) const override;
    int dissipation_terms() const override { return alpha_f_ > alpha_m_ ? 1 : 0; }
    void set_dissipated_rates(const State& state,
                              double time_step,
                              int term,
                              std::vector<NodeMotion>& rates) const override;

    int error_order() const override { return 3; }
    // Estimates the error; algorithmic accelerations belong to a time later by (α_m − α_f) Δt.
    StepError estimate_error(const State& state,
                             double time_step,
                             const NodeLengths& lengths) const override {
        const double later = alpha_m_ - alpha_f_;
        return estimate_newmark_error(
            {newmark_.beta + 0.5 * later - 1.0 / 6.0, 1.0 / 12.0, 0.0}, state, time_step, lengths, true);
    }

  protected:
    void place_nodes(State& state, const Stage& stage, NodeRange nodes) const override;
    void update_nodes(State& state, const Stage& stage, NodeRange nodes) const override;
    void linearize_nodes(const State& state,
                         const Stage& stage,
                         NodeRange nodes,
                         std::vector<NodeLinearization>& linearizations) const override;

  private:
    double alpha_m_;
    double alpha_f_;
    Newmark newmark_;
};

}  // namespace gxrod
