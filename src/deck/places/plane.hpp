#pragma once

#include "deck/supports/support_merge.hpp"

// The deck's `plane`.
namespace gxrod {

// Sets the model's plane, if the deck has one. Adds faults for rods that leave it, or whose sections lean out
// of it. Call it after build_bodies.
void build_plane(BuildContext& context);

// Adds the components that the plane holds to a support, in the support's axes. Adds faults for axes of which
// none is across the plane, and for a move out of it.
void hold_plane(NodeSupport& supported, const BuildContext& context);

}  // namespace gxrod
