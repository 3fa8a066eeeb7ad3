#pragma once

#include <vector>

#include "deck/places/build_context.hpp"
#include "model/settings/signal_plan.hpp"

namespace gxrod {

// Gives the inputs of signals their values at the start, and adds them to the model.
void plan_signals(BuildContext& context);
// Builds the signals. Call it after build_histories.
std::vector<SignalPlan> build_signals(const std::vector<HistoryRequest>& histories,
                                      const BuildContext& context);

}  // namespace gxrod
