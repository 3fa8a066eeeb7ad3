#pragma once

#include "deck/places/build_context.hpp"

namespace gxrod {

// Builds the settings of [analysis], or of each [[stage]], without what acts in it.
std::vector<StagePlan> build_stages(const BuildContext& context);

// Chooses the integrator of the stages that leave it open, once the model and what acts in each are built.
void choose_schemes(BuildContext& context);

}  // namespace gxrod
