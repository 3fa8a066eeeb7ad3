#include "deck/surroundings/check_surroundings.hpp"

#include <algorithm>

#include "deck/bodies/body_table.hpp"
#include "deck/schema/schema_tables.hpp"
#include "deck/schema/top_level.hpp"
#include "deck/sections/section_tables.hpp"
#include "deck/surroundings/build_waves.hpp"

namespace gxrod {
namespace {

constexpr const char* surroundings[] = {"fluid", "air", "seabed"};

// That something takes part, and in something.
void check_parts(const BuildContext& context) {
    const CheckedTable& deck = context.deck;
    const bool is_around =
        std::ranges::any_of(surroundings, [&](const char* key) { return deck.gives(key); });
    bool takes_part = false;
    constexpr const char* nothing_around = "the deck has no [fluid], [air] or [seabed]";
    for (const SectionTable& section : tables_of<SectionTable>(deck, section_table())) {
        if (!section.fluid) continue;
        takes_part = true;
        const bool flows = section.fluid->contents && section.fluid->contents->velocity;
        if (!is_around && !flows) context.add_fault(section, section.fluid, nothing_around);
    }
    for (const BodyTable& body : tables_of<BodyTable>(deck, body_table())) {
        if (!body.fluid) continue;
        takes_part = true;
        if (!is_around) context.add_fault(body, body.fluid, nothing_around);
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

// Whether waves take their depth from the ground.
bool gives_depth(const CheckedTable& deck) {
    const auto fluids = tables_of<FluidTable>(deck, fluid_table());
    return !deck.tables("wave").empty() && !fluids.empty() && !fluids.front().get().depth;
}

// A ground that only bodies could touch, which they do not.
void check_ground(const BuildContext& context) {
    const CheckedTable& deck = context.deck;
    const bool any_section = std::ranges::any_of(
        deck.tables("section"), [](const CheckedTable& section) { return section.gives("fluid"); });
    const bool any_body = std::ranges::any_of(tables_of<BodyTable>(deck, body_table()),
                                              [](const BodyTable& body) { return body.fluid.has_value(); });
    if (any_section || !any_body || gives_depth(deck)) return;
    for (const CheckedTable& ground : deck.tables("seabed")) {
        context.faults.add(
            ground.place,
            ground.path,
            "holds nothing up: it acts on rods whose section has `fluid`, and no section has; "
            "bodies do not touch it. Expected `fluid = {}` in a [section.NAME], or no [seabed]");
    }
}

bool acts_down(const CheckedTable& deck) {
    const CheckedTimeVector* given = find_gravity(deck);
    if (given == nullptr) return false;
    const CheckedTimeVector& gravity = *given;
    const TimeFunction& down = gravity[2].function;
    return gravity[0].function.is_zero() && gravity[1].function.is_zero() &&
           (!down.is_constant() || down(0.0) < 0.0);
}

void check_up(const FluidTable& fluid, const BuildContext& context) {
    if (!fluid.surface || acts_down(context.deck)) return;
    context.add_fault(fluid,
                      fluid.surface,
                      "up is z where water has a surface; expected gravity = [0, 0, -g] with g above 0");
}

// Keys of [fluid] that say something of a surface.
void check_without_surface(const FluidTable& fluid, const BuildContext& context) {
    if (fluid.surface) return;
    const auto refuse = [&](const auto& field) {
        if (fluid.gives(field))
            context.add_fault(fluid, field, "goes with surface: without one there are no waves");
    };
    refuse(fluid.depth);
    refuse(fluid.stretching);
    refuse(fluid.current_stretching);
    refuse(fluid.ramp);
}

void check_no_stretching(const FluidTable& fluid, const BuildContext& context) {
    if (!fluid.current_stretching.value_or(false) || (fluid.current && fluid.current->table)) return;
    context.add_fault(fluid, fluid.current_stretching, "goes with a table of the current");
}

}  // namespace

void check_surroundings(const BuildContext& context) {
    check_parts(context);
    check_ground(context);
    for (const FluidTable& fluid : tables_of<FluidTable>(context.deck, fluid_table())) {
        check_up(fluid, context);
        check_without_surface(fluid, context);
        check_no_stretching(fluid, context);
    }
    check_waves(context);
}

}  // namespace gxrod
