#include "deck/contact/friction_table.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace gxrod {

TableSpec contact_friction_table(const std::string& path) {
    using T = ContactFrictionTable;
    // clang-format off
    return Table<T>(path + ".friction", "")
        .key("static", &T::same, "Coulomb's coefficient in all directions of what rests or slides slowly.")
            .unit("1").at_least(0).also("mu_s sticking rest")
        .key("forward", &T::forward, "In place of `static`: of a rod that slides along itself, towards its end.")
            .unit("1").at_least(0).also("axial along")
        .key("backward", &T::backward, "Of one that slides towards its start.")
            .unit("1").at_least(0).otherwise("`forward`")
        .key("across", &T::across, "Of one that slides across itself, and of bodies.")
            .unit("1").at_least(0).also("lateral sideways transverse")
        .key("kinetic", &T::kinetic, "What is left of `static`, or of `across`, at great speed; along a rod it is as "
             "much less. In statics, where nothing has a speed, it has no effect.")
            .unit("1").at_least(0).otherwise("no less").also("mu_k sliding dynamic")
        .key("stribeck_speed", &T::stribeck_speed, "The speed of slip at which 1/e of the difference is left: with "
             "exp(−(speed/stribeck_speed)²).")
            .unit("length/time").above(0).also("stribeck velocity slip_speed v_s")
        .exactly_one_of({"static", "across"})
        .at_most_one_of({"static", "forward"})
        .at_most_one_of({"static", "backward"});
    // clang-format on
}

namespace {

// Along the rod, relative to across.
void set_directions(const ContactFrictionTable& given, ContactFriction& friction) {
    const double across = *given.across;
    const double forward = given.forward.value_or(across);
    const double backward = given.backward.value_or(forward);
    friction.coefficient = std::max({forward, backward, across});
    if (friction.coefficient == 0.0) return;
    friction.shape.forward = forward / friction.coefficient;
    friction.shape.backward = backward / friction.coefficient;
    friction.shape.across = across / friction.coefficient;
}

}  // namespace

ContactFriction find_contact_friction(const ContactFrictionKey& given, const BuildContext& context) {
    if (!given) return {};
    if (const auto* number = std::get_if<double>(&*given)) return {*number};
    const auto& table = std::get<ContactFrictionTable>(*given);
    ContactFriction friction;
    if (table.same) friction.coefficient = *table.same;
    if (table.across) set_directions(table, friction);
    const double at_rest = table.same ? *table.same : table.across.value_or(0.0);
    if (table.kinetic && !table.stribeck_speed) {
        context.add_fault(
            table, table.kinetic, "says how much is left at great speed; expected `stribeck_speed` with it");
    } else if (!table.kinetic && table.stribeck_speed) {
        context.add_fault(table, table.stribeck_speed, "expected `kinetic` with it");
    } else if (table.kinetic && *table.kinetic > at_rest) {
        context.add_fault(
            table,
            table.kinetic,
            fmt::format("friction that grows with the speed is not there yet; expected at most {:.6g}",
                        at_rest));
    } else if (table.kinetic && *table.kinetic < at_rest) {
        friction.shape.kinetic = *table.kinetic / at_rest;
        friction.shape.stribeck_speed = *table.stribeck_speed;
    }
    return friction;
}

}  // namespace gxrod
