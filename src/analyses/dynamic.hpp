#pragma once

#include "analyses/stepped_analysis.hpp"
#include "model/settings.hpp"

namespace gxrod {

// The scheme of a dynamic or a quasi-static analysis.
std::unique_ptr<Integrator> make_scheme(const DynamicSettings& settings);

// Motion in time from given initial conditions.
class DynamicAnalysis : public SteppedAnalysis {
  public:
    // The model must outlive the analysis.
    DynamicAnalysis(const Model& model, const DynamicSettings& settings, int threads = 1);

    // Solves for the initial accelerations.
    // Throws EvaluationError if the initial velocities do not fit the joints, unless they are to be
    // projected.
    EquilibriumReport start() override;

  private:
    bool projects_start_;
};

}  // namespace gxrod
