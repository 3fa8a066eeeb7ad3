#pragma once

#include "analyses/stepped_analysis.hpp"
#include "model/settings.hpp"

namespace gxrod {

// Motion in time from given initial conditions.
class DynamicAnalysis : public SteppedAnalysis {
  public:
    // The model must outlive the analysis.
    DynamicAnalysis(const Model& model, const DynamicSettings& settings, int threads = 1);

    // Solves for the initial accelerations.
    EquilibriumReport start() override;
};

}  // namespace gxrod
