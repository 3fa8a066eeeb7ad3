#pragma once

#include "deck/build/build_context.hpp"
#include "model/settings.hpp"

namespace gxrod {

// What [analysis] asks for.
AnalysisSettings build_analysis(const BuildContext& context);

}  // namespace gxrod
