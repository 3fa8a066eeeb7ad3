#pragma once

#include "deck/contact/contact_table.hpp"
#include "deck/places/build_context.hpp"

namespace gxrod {

// Lists the ends of the parts of rods in [[contact.pair]], where elements have to end. Skips rods from meshes
// and wrong words, which build_contact_exceptions reports.
std::vector<RodPoint> list_contact_part_ends(const BuildContext& context);

// Builds the exceptions of [[contact.pair]], once the contact has its rods and obstacles.
std::vector<ContactException> build_contact_exceptions(const ContactKeys& contact,
                                                       const BuildContext& context);

// Returns whether exceptions exclude all contact of a rod with another rod or an obstacle.
bool is_left_out(const Contact& contact, int a, int b);

}  // namespace gxrod
