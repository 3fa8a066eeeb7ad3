#include "deck/build/build_springs.hpp"

#include <fmt/format.h>

#include "deck/joints/ends.hpp"

namespace gxrod {
namespace {

// Points nearer than this, relative to the model's size, are at one place.
constexpr double same_place = 1e-9;

// Whether the ends are on two things that can move against each other; a fault if not.
bool are_apart(const CheckedTable& table, const Spring& spring, const BuildContext& context) {
    const auto& words = ends_of(table);
    if (spring.ends[0].node != spring.ends[1].node) return true;
    const std::string both = fmt::format("\"{}\" and \"{}\"", words[0].word, words[1].word);
    context.add_fault(table,
                      "between",
                      spring.ends[0].is_ground()
                          ? "both ends are on the ground; expected a point that moves, too"
                          : both + " are one node, whose points keep their distance");
    return false;
}

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
    if (table.get<double>("damping") == 0.0) return;
    context.add_fault(
        table,
        "damping",
        "the points are at one place at t = 0, where a damper has no direction; expected points "
        "apart, or no damping");
}

void build_spring(const CheckedTable& table, BuildContext& context) {
    const std::optional<Anchor> a = find_anchor(table, 0, "at_a", context);
    const std::optional<Anchor> b = find_anchor(table, 1, "at_b", context);
    if (!a || !b) return;
    Spring spring{.name = table.name,
                  .ends = {*a, *b},
                  .stiffness = table.get<double>("stiffness"),
                  .damping = table.get<double>("damping")};
    if (!are_apart(table, spring, context)) return;
    const double distance = (find_place(context.model, *b) - find_place(context.model, *a)).norm();
    spring.length = table.gives("length") ? table.get<double>("length") : distance;
    if (distance <= same_place * measure_size(context.model, spring.ends))
        check_direction(table, spring.length, context);
    context.model.springs.push_back(spring);
}

}  // namespace

void build_springs(BuildContext& context) {
    for (const CheckedTable& table : context.deck.tables("spring")) build_spring(table, context);
}

}  // namespace gxrod
