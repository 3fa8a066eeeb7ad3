#pragma once

#include "deck/places/build_context.hpp"

namespace gxrod {

// Finds the properties of a body for forces of water and air; nullopt if its table has no `fluid`. Errors
// become faults.
std::optional<BodyInFluid> find_body_fluid(const CheckedTable& body, const BuildContext& context);

}  // namespace gxrod
