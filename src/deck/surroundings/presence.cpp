#include "deck/surroundings/presence.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "model/settings/analysis_traits.hpp"

namespace gxrod {
namespace {

bool has_added_mass(const Model& model) {
    return std::ranges::any_of(
               model.sections,
               [](const Section& one) { return one.fluid && !one.fluid->added_mass.isZero(0.0); }) ||
           std::ranges::any_of(
               model.bodies, [](const Body& one) { return one.fluid && !one.fluid->added_mass.isZero(0.0); });
}

}  // namespace

TimeFunction find_presence(const ActingTable& given, const BuildContext& context) {
    if (!acts_in_stage(given, context)) return TimeFunction(0.0);
    if (!given.factor) return TimeFunction(1.0);
    const Acting acting = find_acting(given, context);
    if (acting.factor && acting.factor->is_constant()) return *acting.factor;
    return acting.apply(TimeFunction(1.0));
}

double find_presence_at_start(const ActingTable& given, const BuildContext& context) {
    return find_presence(given, context)(is_timed(context.analysis()) ? 0.0 : 1.0);
}

void check_added_mass(const FluidTable& fluid, const TimeFunction& factor, const BuildContext& context) {
    const Model& model = context.model;
    if (!model.has_time || !model.has_inertia || factor.is_constant() || !has_added_mass(model)) return;
    if (find_acting(fluid, context).held_at) return;  // the last value of an earlier stage
    const std::string& name = context.stages[context.stage].name;
    context.add_fault(
        fluid,
        fluid.factor,
        fmt::format("changes with t{}, in which water moves along with what moves: its mass cannot come and "
                    "go. Expected a number there, or added_mass = 0 of sections and bodies",
                    name.empty() ? " in a dynamic analysis" : " in the dynamic stage \"" + name + '"'));
}

}  // namespace gxrod
