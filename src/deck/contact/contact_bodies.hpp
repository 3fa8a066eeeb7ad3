#pragma once

#include "deck/places/build_context.hpp"

namespace gxrod {

// Adds the contact shapes of bodies, spheres or capsules, after the rods of the contact and the obstacles.
void set_contact_bodies(Contact& contact, const BuildContext& context);

// Adds faults for features that bodies with shapes do not support.
void check_contact_bodies(const BuildContext& context);

}  // namespace gxrod
