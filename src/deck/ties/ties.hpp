#pragma once

#include "deck/joints/ends.hpp"

// Springs and bushings, which both have two ends. Each has a file of its own: its keys and its builder.
namespace gxrod {

// Whether both ends are on two things that can move against each other; a fault of the key `between` if not.
bool are_apart(const TableHead& table,
               const Ends& between,
               const std::array<Anchor, 2>& ends,
               const BuildContext& context);

// After build_bodies.
void build_springs(BuildContext& context);
void build_bushings(BuildContext& context);

}  // namespace gxrod
