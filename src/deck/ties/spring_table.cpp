#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "deck/reading/copies.hpp"
#include "deck/ties/ties.hpp"
#include "model/spring_law.hpp"
#include "model/ties/ties.hpp"

namespace gxrod {
namespace {

// Points nearer than this, relative to the model's size, are at one place.
constexpr double same_place = 1e-9;

struct SpringTable : TableHead {
    Ends between;
    std::optional<Vec3> at_a, at_b;
    double stiffness = 0.0;
    double damping = 0.0;
    std::optional<CheckedSpringFunction> force;
    std::optional<double> length;
    Copies copies;
};

}  // namespace

const TableSpec& spring_table() {
    using T = SpringTable;
    // clang-format off
    static const TableSpec table = Table<T>("[spring.NAME]",
            "A spring and a damper along the line between two points, A and B. Their force is stiffness times (length "
            "now - length) plus damping times the rate of the length plus force, tension positive.")
        .key("between", &T::between,
             "What carries A and B: points of rods, bodies, or \"ground\" for one that does not move.")
            .required().also("points nodes ends at connects")
        .key("at_a", &T::at_a, "Where A is at t = 0, global. A rigid arm joins it to its node.")
            .unit("length").otherwise("where its node is; of the ground required").also("from point_a position_a")
        .key("at_b", &T::at_b, "Where B is at t = 0, likewise.")
            .unit("length").otherwise("where its node is; of the ground required").also("to point_b position_b")
        .key("stiffness", &T::stiffness, "Force per elongation.")
            .unit("force/length").at_least(0).also("k rate spring_constant spring_rate")
        .key("damping", &T::damping, "Force per rate of elongation.")
            .unit("force·time/length").at_least(0).also("c d damper viscosity damping_constant")
        .key("force", &T::force, "A force in addition, tension positive; length is the distance of A and B then, rate "
             "how fast that grows. A table is a [function.NAME] of the length.")
            .unit("force").otherwise("0").also("law function force_law tension")
        .key("length", &T::length, "At which stiffness pulls and pushes nothing; 0 for one that always pulls.")
            .unit("length").at_least(0).otherwise("as it is at t = 0")
            .also("rest_length free_length natural_length unstretched_length l0 l")
        .with(add_copies<T>)
        .at_least_one_of({"stiffness", "damping", "force"})
        .shown_by(
            "[spring.strut]\n"
            "between   = [\"flyer.start\", \"gyroscope\"]\n"
            "at_b      = [0, 0, 1]\n"
            "stiffness = 500.0\n"
            "damping   = 2.0\n"
            "length    = 0.3\n"
            "\n"
            "[spring.stop]\n"
            "between = [\"ground\", \"gyroscope\"]\n"
            "at_a    = [0, 0, -2]\n"
            "force   = \"length < 0.5 ? 1e4*(length - 0.5) + 20*rate : 0\"\n");
    // clang-format on
    return table;
}

namespace {

// A spring between coincident points has a direction only if it always pulls and does not damp.
void check_direction(const SpringTable& given, double length, const BuildContext& context) {
    if (!given.length) {
        return context.add_fault(
            given,
            given.between,
            "the points are at one place at t = 0, so that the spring has no length; "
            "expected points apart, or length = 0 for a spring that pulls them together");
    }
    if (length > 0.0) {
        return context.add_fault(
            given,
            given.length,
            "the points are at one place at t = 0, where a spring that pushes them apart "
            "has no direction; expected points apart, or length = 0");
    }
    if (given.force) {
        return context.add_fault(given,
                                 given.force,
                                 "the points are at one place at t = 0, where a force along the spring has "
                                 "no direction; expected points apart, or no force");
    }
    if (given.damping == 0.0) return;
    context.add_fault(
        given,
        given.damping,
        "the points are at one place at t = 0, where a damper has no direction; expected points "
        "apart, or no damping");
}

// A force that has no value at t = 0 is a fault.
void set_law(const SpringTable& given, double distance, Spring& spring, const BuildContext& context) {
    const SpringExpression& force = given.force->expression;
    const double at_start = force.function(distance, 0.0);
    if (!std::isfinite(at_start)) {
        context.add_fault(given,
                          given.force,
                          fmt::format("is {} at t = 0, with length = {} and rate = 0", at_start, distance));
        return;
    }
    spring.law = std::make_shared<const SpringLaw>(force.function, force.has_rate, distance);
}

void build_spring(const SpringTable& given, BuildContext& context) {
    const std::optional<Anchor> a = find_anchor(given, given.between[0], given.at_a, context);
    const std::optional<Anchor> b = find_anchor(given, given.between[1], given.at_b, context);
    if (!a || !b) return;
    Spring spring{
        .name = given.name, .ends = {*a, *b}, .stiffness = given.stiffness, .damping = given.damping};
    if (!are_apart(given, given.between, spring.ends, context)) return;
    const double distance = (find_place(context.model, *b) - find_place(context.model, *a)).norm();
    spring.length = given.length.value_or(distance);
    const bool has_direction = distance > same_place * measure_size(context.model, spring.ends);
    if (!has_direction) check_direction(given, spring.length, context);
    if (given.force && has_direction) set_law(given, distance, spring, context);
    context.model.springs.push_back(spring);
}

}  // namespace

bool are_apart(const TableHead& table,
               const Ends& between,
               const std::array<Anchor, 2>& ends,
               const BuildContext& context) {
    if (ends[0].node != ends[1].node) return true;
    const std::string both = fmt::format("\"{}\" and \"{}\"", between[0].word, between[1].word);
    context.add_fault(table,
                      between,
                      ends[0].is_ground() ? "both ends are on the ground; expected a point that moves, too"
                                          : both + " are one node, whose points keep their distance");
    return false;
}

std::vector<std::string> list_tie_words() {
    std::vector<std::string> words;
    for (const TieCard& card : tie_cards) {
        if (std::ranges::find(words, card.table) == words.end()) words.emplace_back(card.table);
    }
    return words;
}

void build_springs(BuildContext& context) {
    for (const SpringTable& given : tables_of<SpringTable>(context.deck, spring_table()))
        build_spring(given, context);
}

}  // namespace gxrod
