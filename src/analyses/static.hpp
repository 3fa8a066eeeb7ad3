#pragma once

#include "analyses/stepped_analysis.hpp"
#include "model/settings.hpp"

namespace gxrod {

// Equilibria while the load factor runs from 0, the reference shape, to 1.
class StaticAnalysis : public SteppedAnalysis {
  public:
    // The model must outlive the analysis.
    StaticAnalysis(const Model& model, const StaticSettings& settings);

    EquilibriumReport start() override;
};

// The analysis that the settings ask for.
std::unique_ptr<SteppedAnalysis> make_analysis(const Model& model, const AnalysisSettings& settings);

}  // namespace gxrod
