#include "deck/surroundings/check_surroundings.hpp"

#include <algorithm>

#include "deck/surroundings/build_waves.hpp"

namespace gxrod {
namespace {

constexpr const char* surroundings[] = {"fluid", "air", "seabed"};
constexpr const char* parts[] = {"section", "body"};

// That something takes part, and in something.
void check_parts(const BuildContext& context) {
    const CheckedTable& deck = context.deck;
    const bool is_around =
        std::ranges::any_of(surroundings, [&](const char* key) { return deck.gives(key); });
    bool takes_part = false;
    for (const char* kind : parts) {
        for (const CheckedTable& part : deck.tables(kind)) {
            if (!part.gives("fluid")) continue;
            takes_part = true;
            if (!is_around) context.add_fault(part, "fluid", "the deck has no [fluid], [air] or [seabed]");
        }
    }
    if (takes_part) return;
    for (const char* key : surroundings) {
        for (const CheckedTable& table : deck.tables(key)) {
            context.faults.add(table.place,
                               table.path,
                               "passes everything by; expected `fluid = {}` in a [section.NAME], or `fluid` "
                               "in a [body.NAME]");
        }
    }
}

bool any_gives_fluid(const std::vector<CheckedTable>& tables) {
    return std::ranges::any_of(tables, [](const CheckedTable& table) { return table.gives("fluid"); });
}

// Whether waves take their depth from the ground.
bool gives_depth(const CheckedTable& deck) {
    const std::vector<CheckedTable>& fluids = deck.tables("fluid");
    return !deck.tables("wave").empty() && !fluids.empty() && !fluids.front().gives("depth");
}

// A ground that only bodies could touch, which they do not.
void check_ground(const BuildContext& context) {
    const CheckedTable& deck = context.deck;
    if (any_gives_fluid(deck.tables("section")) || !any_gives_fluid(deck.tables("body")) || gives_depth(deck))
        return;
    for (const CheckedTable& ground : deck.tables("seabed")) {
        context.faults.add(
            ground.place,
            ground.path,
            "holds nothing up: it acts on rods whose section has `fluid`, and no section has; "
            "bodies do not touch it. Expected `fluid = {}` in a [section.NAME], or no [seabed]");
    }
}

bool acts_down(const CheckedTable& deck) {
    if (!deck.gives("gravity")) return false;
    const auto& gravity = deck.get<CheckedTimeVector>("gravity");
    const TimeFunction& down = gravity[2].function;
    return gravity[0].function.is_zero() && gravity[1].function.is_zero() &&
           (!down.is_constant() || down(0.0) < 0.0);
}

void check_up(const CheckedTable& fluid, const BuildContext& context) {
    if (!fluid.gives("surface") || acts_down(context.deck)) return;
    context.add_fault(
        fluid, "surface", "up is z where water has a surface; expected gravity = [0, 0, -g] with g above 0");
}

// Keys of [fluid] that say something of a surface.
void check_without_surface(const CheckedTable& fluid, const BuildContext& context) {
    if (fluid.gives("surface")) return;
    for (const char* key : {"depth", "stretching", "current_stretching", "ramp"}) {
        if (fluid.gives(key))
            context.add_fault(fluid, key, "goes with surface: without one there are no waves");
    }
}

void check_no_stretching(const CheckedTable& fluid, const BuildContext& context) {
    if (!fluid.gives("current_stretching") || !fluid.get<bool>("current_stretching")) return;
    const std::vector<CheckedTable>& currents = fluid.tables("current");
    if (!currents.empty() && currents.front().gives("table")) return;
    context.add_fault(fluid, "current_stretching", "goes with a table of the current");
}

}  // namespace

void check_surroundings(const BuildContext& context) {
    check_parts(context);
    check_ground(context);
    for (const CheckedTable& fluid : context.deck.tables("fluid")) {
        check_up(fluid, context);
        check_without_surface(fluid, context);
        check_no_stretching(fluid, context);
    }
    check_waves(context);
}

}  // namespace gxrod
