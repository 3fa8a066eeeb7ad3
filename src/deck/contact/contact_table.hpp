#pragma once

#include <array>
#include <optional>
#include <vector>

#include "deck/contact/friction_table.hpp"
#include "deck/places/build_context.hpp"
#include "deck/table/kinds.hpp"

// [contact].
namespace gxrod {

struct ContactPairTable : TableHead {
    Partners between;
    ContactFrictionKey friction;
    std::optional<double> restitution;
    std::optional<bool> off;
};

struct ContactKeys : TableHead {
    std::optional<TableNames> rods;
    bool each_other = true;
    bool self = true;
    std::optional<double> bend_radius;
    ContactFrictionKey friction;
    double skin = 0.02;
    std::optional<double> dissipation;
    double damping = 0.0;
    std::optional<double> restitution;
    std::vector<ContactPairTable> pairs;
};

// The table of the deck; nullptr without one.
const ContactKeys* find_contact(const CheckedTable& deck);

// Adds contact to the model: obstacles, their motions in the current stage, and pairs of rods. Call it after
// build_rods.
void build_contact(BuildContext& context);

// Adds faults for analyses that do not support contact. Call it after choose_schemes.
void check_contact(const BuildContext& context);

}  // namespace gxrod
