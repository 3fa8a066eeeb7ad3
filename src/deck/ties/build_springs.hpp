#pragma once

#include "deck/places/build_context.hpp"

namespace gxrod {

// Whether both ends, those of the table's `between`, are on two things that can move against each other; a
// fault if not.
bool are_apart(const CheckedTable& table, const std::array<Anchor, 2>& ends, const BuildContext& context);

// After build_bodies.
void build_springs(BuildContext& context);

}  // namespace gxrod
