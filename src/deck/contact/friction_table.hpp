#pragma once

#include <optional>
#include <string>
#include <variant>

#include "deck/places/build_context.hpp"
#include "deck/table/table.hpp"
#include "model/contact_friction.hpp"

// `friction` of [contact], [[contact.pair]] and [obstacle.NAME]: a number, or a table.
namespace gxrod {

struct ContactFrictionTable : TableHead {
    std::optional<double> same;  // `static`
    std::optional<double> forward, backward, across;
    std::optional<double> kinetic;
    std::optional<double> stribeck_speed;
};

using ContactFrictionKey = std::optional<std::variant<double, ContactFrictionTable>>;

// Returns the table for the key `friction` of a table with this path.
TableSpec contact_friction_table(const std::string& path);

// The largest coefficient, and the shares of it.
struct ContactFriction {
    double coefficient = 0.0;
    FrictionShape shape{};
};
// Returns the friction of a key that is given, with faults where it cannot be.
ContactFriction find_contact_friction(const ContactFrictionKey& given, const BuildContext& context);

}  // namespace gxrod
