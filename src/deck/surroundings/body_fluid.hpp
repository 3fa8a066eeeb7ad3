#pragma once

#include "deck/bodies/body_table.hpp"

namespace gxrod {

// Finds the properties of a body for forces of water and air. Errors become faults.
BodyInFluid find_body_fluid(const BodyFluidTable& given, const BuildContext& context);

}  // namespace gxrod
