#pragma once

#include "deck/build/build_context.hpp"

namespace gxrod {

// What [analysis], or each [[stage]], asks for; without what acts in it.
std::vector<StagePlan> build_stages(const BuildContext& context);

}  // namespace gxrod
