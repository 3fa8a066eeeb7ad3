#include <fmt/format.h>

#include <string_view>

#include "deck/joints/joint_table.hpp"

namespace gxrod {
namespace {

// The part χ of a push that a rate of 1 adds: a contact with it gives back the part e of the speed v.
double find_hysteresis(double e, double v) { return 0.75 * (1.0 - e * e) / v; }

// What belongs to another key is given with it, and only with it.
void check_companions(const JointClearanceTable& given, const BuildContext& context) {
    const auto check = [&](bool is_needed,
                           const std::optional<double>& value,
                           std::string_view other,
                           const char* expected) {
        if (is_needed && !value)
            context.add_fault(
                given, value, fmt::format("missing; expected {}, a number greater than 0", expected));
        if (!is_needed && value)
            context.add_fault(given, value, fmt::format("goes with {}, which this table has not", other));
    };
    check(given.restitution.has_value(),
          given.impact_speed,
          "restitution",
          "the speed of impact for which `restitution` is given");
    const bool rubs = given.gives(given.friction);
    check(rubs, given.radius, "friction", "the radius of the pin or ball on which the friction acts");
    check(rubs, given.slip_speed, "friction", "the speed of slip at which friction has 0.7 of its limit");
}

}  // namespace

JointClearance build_clearance(const JointTable& given, const BuildContext& context) {
    const JointClearanceTable& table = *given.clearance;
    check_companions(table, context);
    if (given.breaks)
        context.add_fault(
            given, given.breaks, "a joint with clearance does not break; expected one of the two");
    const auto check_friction = [&](const std::optional<JointFrictionTable>& friction) {
        if (friction && friction->coefficient)
            context.add_fault(
                *friction,
                friction->coefficient,
                "the joint has a clearance, whose contact carries the force; expected `friction` "
                "there");
    };
    if (given.friction) {
        check_friction(*given.friction);
        check_friction(given.friction->turn);
        check_friction(given.friction->slide);
    }
    JointClearance built;
    built.contact = {.lower = std::nullopt,
                     .upper = table.gap,
                     .stiffness = table.stiffness,
                     .damping = table.damping,
                     .exponent = table.exponent};
    if (table.restitution && table.impact_speed)
        built.contact.hysteresis = find_hysteresis(*table.restitution, *table.impact_speed);
    built.friction = table.friction;
    built.radius = table.radius.value_or(0.0);
    built.slip_speed = table.slip_speed.value_or(0.0);
    return built;
}

}  // namespace gxrod
