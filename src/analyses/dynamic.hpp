#pragma once

#include <optional>

#include "analyses/stepped_analysis.hpp"
#include "integrators/instant_step.hpp"
#include "model/settings/settings.hpp"
#include "model/time/breaks.hpp"

namespace gxrod {

// Makes the scheme of a dynamic or a quasi-static analysis.
std::unique_ptr<Integrator> make_scheme(const DynamicSettings& settings);

// Motion in time from given initial conditions.
class DynamicAnalysis : public SteppedAnalysis {
  public:
    // The model must outlive the analysis.
    DynamicAnalysis(const Model& model, const DynamicSettings& settings, int threads = 1);

    // Solves for the initial accelerations; without inertia, for the equilibrium under loads that jump at the
    // start. Throws EvaluationError if the initial velocities do not fit the joints, unless they are to be
    // projected.
    EquilibriumReport start() override;

    Stage settling_stage() const override;
    const Integrator& settling_integrator() const override { return instant_step_; }

  protected:
    bool settles_here() const override;
    double trial_time() const override;
    void recall(const RestartRecord&) override { find_jumps(); }

  private:
    // Finds the times at which steps have to end: where joints break, and, without inertia, where an action
    // jumps.
    void find_jumps();
    std::optional<double> find_jump_at(double time) const;

    bool projects_start_;
    Interval times_;
    int samples_;  // samples of functions, to find jumps
    InstantStep instant_step_;
};

}  // namespace gxrod
