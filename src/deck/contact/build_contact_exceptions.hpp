#pragma once

#include "deck/places/build_context.hpp"

namespace gxrod {

// The ends of the parts of rods that [[contact.pair]] names, where elements end; none of words that are not
// right, which build_contact_exceptions says, and of rods from meshes.
std::vector<RodPoint> list_contact_part_ends(const BuildContext& context);

// Of [[contact.pair]], once the contact has its rods and obstacles.
std::vector<ContactException> build_contact_exceptions(const CheckedTable& contact,
                                                       const BuildContext& context);

// Whether exceptions leave out all of what would touch: a rod and a rod, or an obstacle.
bool is_left_out(const Contact& contact, int a, int b);

}  // namespace gxrod
