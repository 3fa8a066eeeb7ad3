#pragma once

#include "deck/supports/support_merge.hpp"

// The deck's `plane`.
namespace gxrod {

// Sets the model's plane, if the deck has one. Faults: rods that leave it, or whose sections lean out of it.
// After build_bodies.
void build_plane(BuildContext& context);

// Adds what the plane holds to a support, in the support's axes. Faults: axes of which none is across the
// plane, a move out of it.
void hold_plane(NodeSupport& supported, const BuildContext& context);

}  // namespace gxrod
