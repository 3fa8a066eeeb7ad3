#pragma once

#include "analyses/stepped_analysis.hpp"
#include "model/settings.hpp"

namespace gxrod {

// Equilibria while the load factor runs from 0, the reference shape, to 1.
class StaticAnalysis : public SteppedAnalysis {
  public:
    // The model must outlive the analysis.
    StaticAnalysis(const Model& model, const StaticSettings& settings, int threads = 1);

    EquilibriumReport start() override;
};

// The analysis that the settings ask for; so many threads share its work, and their number changes no result.
std::unique_ptr<SteppedAnalysis> make_analysis(const Model& model,
                                               const AnalysisSettings& settings,
                                               int threads = 1);

}  // namespace gxrod
