#pragma once

#include "model/model.hpp"
#include "model/settings/settings.hpp"
#include "model/settings/stage.hpp"

namespace gxrod {

// The size of a run's results as far as its deck determines it: without adaptive steps and their frames, and
// without compressed frames.
struct ResultsSize {
    double steps = 0.0;
    double frames = 0.0;
    double bytes = 0.0;
};

ResultsSize estimate_results_size(const Model& model,
                                  std::span<const StagePlan> stages,
                                  const OutputSettings& output);
ResultsSize estimate_results_size(const Model& model,
                                  const AnalysisSettings& analysis,
                                  const OutputSettings& output);

}  // namespace gxrod
