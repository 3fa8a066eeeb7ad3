#pragma once

#include "deck/places/build_context.hpp"

namespace gxrod {

// What water and air see of a body by its table; nullopt if that says nothing of `fluid`. What is wrong goes
// to the faults.
std::optional<BodyInFluid> find_body_fluid(const CheckedTable& body, const BuildContext& context);

}  // namespace gxrod
