#include "deck/rods/still_water.hpp"

#include <algorithm>

#include "deck/loads/combinations.hpp"
#include "deck/loads/gravity_table.hpp"
#include "deck/schema/schema_tables.hpp"
#include "deck/schema/top_level.hpp"
#include "deck/surroundings/build_seabed.hpp"
#include "deck/surroundings/presence.hpp"
#include "deck/surroundings/surroundings_tables.hpp"

namespace gxrod {
namespace {

// How a rod lies on the ground: from its line to what touches, and how deep it sinks in by its weight in
// water.
struct Lying {
    double radius = 0.0;
    double depth = 0.0;
};

Lying find_lying(const Section* section, const BuildContext& context) {
    if (section == nullptr || !section->fluid) return {};
    const double diameter = section->fluid->diameter;
    const double weight = find_still_water(context).weight_in_water(*section);
    const SeabedTable& seabed = tables_of<SeabedTable>(context.deck, seabed_table()).front();
    const double stiffness = find_presence_at_start(seabed, context) * seabed.stiffness;
    return {0.5 * diameter, std::max(weight, 0.0) / (stiffness * diameter)};
}

}  // namespace

StillWater find_still_water(const BuildContext& context) {
    StillWater water;
    if (const CheckedTimeVector* given = find_gravity(context.deck)) {
        for (int i = 0; i < 3; ++i) water.gravity[i] = (*given)[static_cast<std::size_t>(i)].function(1.0);
        water.gravity *= find_gravity_factor(context);
    }
    const auto fluids = tables_of<FluidTable>(context.deck, fluid_table());
    if (fluids.empty()) return water;
    const FluidTable& fluid = fluids.front();
    const double factor = find_presence_at_start(fluid, context);
    if (factor == 0.0) return water;
    water.density = factor * fluid.density;
    water.surface = fluid.surface;
    return water;
}

std::optional<double> find_line_bed(const CatenaryTable& catenary,
                                    const Section* section,
                                    const BuildContext& context) {
    if (!catenary.bed) return std::nullopt;
    std::optional<double> bed = find_bed_height(context.deck);
    if (!bed) {
        context.add_fault(catenary,
                          catenary.bed,
                          context.deck.gives("seabed")
                              ? "a line can be laid on horizontal ground only, and this [seabed] is not"
                              : "the deck has no [seabed]; expected one with a height z");
        return std::nullopt;
    }
    if (find_presence_at_start(tables_of<SeabedTable>(context.deck, seabed_table()).front(), context) <=
        0.0) {
        context.add_fault(catenary,
                          catenary.bed,
                          "there is no ground in the first stage to lie on: [seabed] has stages or a factor; "
                          "expected a ground that is there from the first stage on");
        return std::nullopt;
    }
    const Lying lying = find_lying(section, context);
    const double lowest = std::min(catenary.from.z(), catenary.to.z());
    *bed += lying.radius - lying.depth;
    if (lowest < *bed && lowest > *bed - 4.0 * lying.radius) bed = lowest;
    return bed;
}

}  // namespace gxrod
