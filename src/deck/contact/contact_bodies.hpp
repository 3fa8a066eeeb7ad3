#pragma once

#include "deck/places/build_context.hpp"

namespace gxrod {

// The shapes of bodies, sphere or capsule, with which they touch. After the rods of the contact and the
// obstacles.
void set_contact_bodies(Contact& contact, const BuildContext& context);

// Of a deck whose bodies have shapes: what cannot be had together with them.
void check_contact_bodies(const BuildContext& context);

}  // namespace gxrod
