#pragma once

#include "deck/places/build_context.hpp"
#include "model/settings/settings.hpp"

namespace gxrod {

// What [output] and [[history]] ask for. After build_supports.
OutputSettings build_output(const BuildContext& context);

}  // namespace gxrod
