#pragma once

#include "deck/build_context.hpp"
#include "model/settings.hpp"

namespace gxrod {

// What [analysis] asks for.
AnalysisSettings build_analysis(const BuildContext& context);

// Checks that the linear solver is one for the model. After build_loads.
void check_linear_solver(const BuildContext& context);

}  // namespace gxrod
