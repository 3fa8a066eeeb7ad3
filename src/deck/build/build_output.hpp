#pragma once

#include "deck/build/build_context.hpp"
#include "model/settings.hpp"

namespace gxrod {

// What [output] and [[history]] ask for. After build_supports.
OutputSettings build_output(const BuildContext& context);

}  // namespace gxrod
