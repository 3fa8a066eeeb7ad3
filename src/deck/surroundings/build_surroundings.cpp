#include "deck/surroundings/build_surroundings.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "deck/drives/place_field.hpp"
#include "deck/loads/acting.hpp"
#include "deck/schema/choices.hpp"
#include "deck/surroundings/build_seabed.hpp"
#include "deck/surroundings/build_waves.hpp"
#include "deck/surroundings/check_surroundings.hpp"

namespace gxrod {
namespace {

// The table of a key that a deck can have once; nullptr without it.
const CheckedTable* find_only(const CheckedTable& table, const char* key) {
    const std::vector<CheckedTable>& tables = table.tables(key);
    return tables.empty() ? nullptr : &tables.front();
}

std::optional<SpeedProfile> find_profile(const CheckedTable& table,
                                         const Acting& acting,
                                         const BuildContext& context) {
    const CheckedPairs& pairs = table.get<CheckedPairs>("table");
    SpeedProfile profile{.heights = {}, .speeds = {}, .direction = table.get<Vec3>("direction")};
    for (std::size_t i = 0; i < pairs.rows.size(); ++i) {
        const auto& [height, speed] = pairs.rows[i];
        if (i > 0 && height <= profile.heights.back()) {
            context.faults.add(
                pairs.places[i],
                fmt::format("{}[{}]", table.path_of("table"), i),
                fmt::format("z must rise from row to row: {} follows {}", height, profile.heights.back()));
            return std::nullopt;
        }
        profile.heights.push_back(height);
        profile.speeds.push_back(speed);
    }
    if (profile.direction.isZero(0.0)) {
        context.add_fault(table, "direction", "expected a direction, found a vector of zero length");
        return std::nullopt;
    }
    profile.direction.stableNormalize();
    profile.factor = acting.apply(TimeFunction(1.0));
    return profile;
}

Flow find_flow(const CheckedTable* table, const BuildContext& context) {
    if (table == nullptr) return {};
    const Acting acting = find_acting(*table, context);
    if (acting.is_absent) return {};
    Flow flow;
    if (table->gives("table")) {
        flow.profile = find_profile(*table, acting, context);
        return flow;
    }
    flow.field = [field = make_field(table->get<CheckedMotionVector>("velocity"), acting)](
                     double time, const Vec3& position) -> Vec3 {
        const Vec3 uniform(field.uniform[0](time), field.uniform[1](time), field.uniform[2](time));
        return field.by_place ? Vec3(uniform + field.by_place(time, position)) : uniform;
    };
    return flow;
}

Water find_water(const CheckedTable& table, const SurroundingsFiles& files, const BuildContext& context) {
    Water water{.density = table.get<double>("density")};
    if (table.gives("surface")) water.surface = table.get<double>("surface");
    water.depth = find_depth(table, context);
    water.current = find_flow(find_only(table, "current"), context);
    water.stretching = value_of(stretching_choices, table.get<std::string>("stretching"));
    water.stretches_current = table.gives("current_stretching") && table.get<bool>("current_stretching");
    set_waves(files, water, context);
    if (!water.waves.empty()) water.ramp = table.get<double>("ramp");
    return water;
}

}  // namespace

void build_surroundings(const SurroundingsFiles& files, BuildContext& context) {
    const CheckedTable& deck = context.deck;
    if (context.stage == 0) check_surroundings(context);
    Surroundings& around = context.model.surroundings;
    if (const CheckedTable* table = find_only(deck, "fluid"))
        around.water = find_water(*table, files, context);
    if (const CheckedTable* table = find_only(deck, "air"))
        around.air = Air{table->get<double>("density"), find_flow(find_only(*table, "wind"), context)};
    if (const CheckedTable* table = find_only(deck, "seabed"))
        around.seabed = find_seabed(*table, files.ground, context);
}

}  // namespace gxrod
