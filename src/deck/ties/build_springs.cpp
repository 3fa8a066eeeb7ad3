#include "deck/ties/build_springs.hpp"

#include <fmt/format.h>

#include <array>
#include <cmath>

#include "deck/joints/ends.hpp"
#include "model/spring_law.hpp"

namespace gxrod {
namespace {

// Points nearer than this, relative to the model's size, are at one place.
constexpr double same_place = 1e-9;

// A spring between coincident points has a direction only if it always pulls and does not damp.
void check_direction(const CheckedTable& table, double length, const BuildContext& context) {
    if (!table.gives("length")) {
        return context.add_fault(
            table,
            "between",
            "the points are at one place at t = 0, so that the spring has no length; "
            "expected points apart, or length = 0 for a spring that pulls them together");
    }
    if (length > 0.0) {
        return context.add_fault(
            table,
            "length",
            "the points are at one place at t = 0, where a spring that pushes them apart "
            "has no direction; expected points apart, or length = 0");
    }
    if (table.gives("force")) {
        return context.add_fault(table,
                                 "force",
                                 "the points are at one place at t = 0, where a force along the spring has "
                                 "no direction; expected points apart, or no force");
    }
    if (table.get<double>("damping") == 0.0) return;
    context.add_fault(
        table,
        "damping",
        "the points are at one place at t = 0, where a damper has no direction; expected points "
        "apart, or no damping");
}

// A force that has no value at t = 0 is a fault.
void set_law(const CheckedTable& table, double distance, Spring& spring, const BuildContext& context) {
    const SpringExpression& force = table.get<CheckedSpringFunction>("force").expression;
    const double at_start = force.function(distance, 0.0);
    if (!std::isfinite(at_start)) {
        context.add_fault(
            table, "force", fmt::format("is {} at t = 0, with length = {} and rate = 0", at_start, distance));
        return;
    }
    spring.law = std::make_shared<const SpringLaw>(force.function, force.has_rate, distance);
}

void build_spring(const CheckedTable& table, BuildContext& context) {
    const std::optional<Anchor> a = find_anchor(table, 0, "at_a", context);
    const std::optional<Anchor> b = find_anchor(table, 1, "at_b", context);
    if (!a || !b) return;
    Spring spring{.name = table.name,
                  .ends = {*a, *b},
                  .stiffness = table.get<double>("stiffness"),
                  .damping = table.get<double>("damping")};
    if (!are_apart(table, spring.ends, context)) return;
    const double distance = (find_place(context.model, *b) - find_place(context.model, *a)).norm();
    spring.length = table.gives("length") ? table.get<double>("length") : distance;
    const bool has_direction = distance > same_place * measure_size(context.model, spring.ends);
    if (!has_direction) check_direction(table, spring.length, context);
    if (table.gives("force") && has_direction) set_law(table, distance, spring, context);
    context.model.springs.push_back(spring);
}

}  // namespace

bool are_apart(const CheckedTable& table, const std::array<Anchor, 2>& ends, const BuildContext& context) {
    const auto& words = ends_of(table);
    if (ends[0].node != ends[1].node) return true;
    const std::string both = fmt::format("\"{}\" and \"{}\"", words[0].word, words[1].word);
    context.add_fault(table,
                      "between",
                      ends[0].is_ground() ? "both ends are on the ground; expected a point that moves, too"
                                          : both + " are one node, whose points keep their distance");
    return false;
}

void build_springs(BuildContext& context) {
    for (const CheckedTable& table : context.deck.tables("spring")) build_spring(table, context);
}

}  // namespace gxrod
