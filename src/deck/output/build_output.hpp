#pragma once

#include "deck/places/build_context.hpp"
#include "model/settings/settings.hpp"

namespace gxrod {

// Builds the settings of [output] and [[history]]. After build_supports.
OutputSettings build_output(const BuildContext& context);

}  // namespace gxrod
