#pragma once

#include "deck/build/build_context.hpp"

namespace gxrod {

// Of [[contact.pair]], once the contact has its rods and obstacles.
std::vector<ContactException> build_contact_exceptions(const CheckedTable& contact,
                                                       const BuildContext& context);

// Whether exceptions leave out all of what would touch: a rod and a rod, or an obstacle.
bool is_left_out(const Contact& contact, int a, int b);

}  // namespace gxrod
