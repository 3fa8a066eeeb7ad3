#pragma once

#include "integrators/integrator.hpp"
#include "integrators/newmark.hpp"

namespace gxrod {

// Generalized-α of Chung & Hulbert on the rotation group in the form of Arnold & Brüls (2007): equilibrium at
// the end of the step, spatial rates, and an algorithmic acceleration A per node that lags the true one: (1 −
// α_m) A + α_m A_n = (1 − α_f) α + α_f α_n. Second order; the spectral radius at infinite frequency sets the
// damping, from 1 (none) to 0. Impulses of contact go into velocities at once, and into positions by β/γ Δt,
// less the part of β/γ − ½ in the next step (docs/theory/contact.md, (C24)).
class GeneralizedAlpha : public Integrator {
  public:
    explicit GeneralizedAlpha(double spectral_radius);

    // Carries the algorithmic accelerations, and what impulses added to the mean acceleration of the step.
    int carried_count() const override { return 2; }
    void start(State& state) const override;
    double contact_weight() const override;
    void split_impulses(State& state, const Stage& stage, std::vector<Vec6>& shocked) const override;
    bool has_transposed_rates() const override { return true; }
    void transpose_rates(const State& state,
                         double time_step,
                         const MotionGradient& rates,
                         MotionGradient& trial,
                         MotionGradient& previous) const override;
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
    template <class Carried>
    static auto& algorithmic(Carried& carried, std::size_t node) {
        return carried[2 * node];
    }
    template <class Carried>
    static auto& impulsive(Carried& carried, std::size_t node) {
        return carried[2 * node + 1];
    }

    double alpha_m_;
    double alpha_f_;
    Newmark newmark_;
    double lag_;  // β/γ − ½
};

}  // namespace gxrod
