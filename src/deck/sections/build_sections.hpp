#pragma once

#include "deck/build/build_context.hpp"

namespace gxrod {

// Adds the sections to the model.
void build_sections(BuildContext& context);

}  // namespace gxrod
