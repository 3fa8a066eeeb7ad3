#pragma once

#include "deck/places/build_context.hpp"

namespace gxrod {

// What [analysis], or each [[stage]], asks for; without what acts in it.
std::vector<StagePlan> build_stages(const BuildContext& context);

// Of the stages whose integrator is left open, once the model and what acts in each are built.
void choose_schemes(BuildContext& context);

}  // namespace gxrod
