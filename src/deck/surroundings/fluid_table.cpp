#include "deck/surroundings/build_surroundings.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "deck/drives/place_field.hpp"
#include "deck/loads/combinations.hpp"
#include "deck/schema/schema_tables.hpp"
#include "deck/surroundings/build_seabed.hpp"
#include "deck/surroundings/build_waves.hpp"
#include "deck/surroundings/check_surroundings.hpp"
#include "deck/surroundings/presence.hpp"

namespace gxrod {
namespace {

TableSpec flow_table(const char* path, const char* what) {
    using T = FlowTable;
    // clang-format off
    return Table<T>(path, "")
        .key("table", &T::table,
             "Rows of a height z and the flow there, z rising from row to row: linear between them, constant beyond. "
             "[z, speed] along `direction`; [z, speed, degrees], the direction to which it flows, from x towards y, "
             "turning by the shorter way from row to row; or [z, vx, vy, vz].")
            .unit("length, length/time").also("profile rows")
        .key("direction", &T::direction, "Where it flows to, of any length.")
            .unit("1").otherwise("with rows [z, speed] required").only_with("table")
        .key("velocity", &T::velocity, "By time and place, global components.")
            .unit("length/time").also("v speed")
        .key("factor", &T::factor, factor_sentence(what))
            .unit("1").otherwise(factor_default)
        .key("stages", &T::stages, "The stages in which it flows.")
            .otherwise("all").names_of({"stage"})
        .with(add_load_case<T>)
        .exactly_one_of({"table", "velocity"});
    // clang-format on
}

}  // namespace

const TableSpec& fluid_table() {
    using T = FluidTable;
    static const TableSpec current = flow_table("fluid.current", "current");
    // clang-format off
    static const TableSpec table = Table<T>("[fluid]",
            "The water around sections and bodies that have a key `fluid`. [Water, wind and ground](guide/water.md) "
            "explains it.")
        .key("density", &T::density, "Mass per volume.")
            .unit("mass/length³").above(0).required().also("rho")
        .key("surface", &T::surface, "z of still water: up is z, and gravity acts down.")
            .unit("length").otherwise("none: water everywhere")
            .also("z level surface_level water_level swl msl sea_level")
        .key("depth", &T::depth, "Of the water that waves feel.")
            .unit("length").above(0).otherwise("down to a horizontal [seabed]; without one the water is deep")
            .also("water_depth d")
        .key("current", &T::current, current, "How it flows without waves; still if left out.")
        .has_as("current.velocity", "velocity")
        .key("stretching", &T::stretching, "How linear waves reach the moving surface. wheeler: the profile from bed "
             "to still water is drawn out to it. vertical: above still water as at it. extrapolate: along the tangent "
             "there. none: by the formulas of below.")
            .also("kinematic_stretching wave_stretching")
        .key("current_stretching", &T::current_stretching,
             "Whether the table of the current is drawn out to the surface, as by wheeler.")
            .otherwise("false")
        .key("ramp", &T::ramp, "How long waves take to grow, from the start of the first stage that has them.")
            .unit("time").at_least(0)
        .key("factor", &T::factor, "What all forces of the water are multiplied by, as its density would do: buoyancy, "
             "pressure, drag and added mass. By t of a stage, or by stage: a stage that is not named keeps the last "
             "value, and before the first one there is no water.")
            .unit("1").otherwise("1")
        .key("stages", &T::stages, "The stages in which there is water. In others [air] is everywhere.")
            .otherwise("all").names_of({"stage"})
        .shown_by(
            "[fluid]\n"
            "density = 1025\n"
            "surface = 20\n"
            "depth   = 100\n"
            "current = { table = [[-80, 0.2], [20, 1.2]], direction = [1, 0, 0] }\n"
            "ramp    = 5\n");
    // clang-format on
    return table;
}

const TableSpec& air_table() {
    using T = AirTable;
    static const TableSpec wind = flow_table("air.wind", "wind");
    // clang-format off
    static const TableSpec table = Table<T>("[air]",
            "The air around sections and bodies that have a key `fluid`, above the water if there is any.")
        .key("density", &T::density, "Mass per volume.")
            .unit("mass/length³").above(0).required().also("rho")
        .key("wind", &T::wind, wind, "How it flows; still if left out.")
        .has_as("wind.velocity", "velocity speed")
            .also("profile flow")
        .shown_by(
            "[air]\n"
            "density = 1.225\n"
            "wind    = { velocity = [\"10*(max(z - 20, 0.1)/10)^0.14\", 0, 0] }\n");
    // clang-format on
    return table;
}

namespace {

// The key `direction` goes with rows of 2; null with a fault where it is missing or too much.
std::optional<Vec3> find_flow_direction(const FlowTable& given, const BuildContext& context) {
    const bool has_own = given.table->width() > 2;
    if (has_own && given.direction)
        context.add_fault(given, given.direction, "goes with rows [z, speed]; these rows have directions");
    if (has_own) return Vec3::UnitX();
    if (!given.direction) {
        context.add_fault(
            given,
            given.table,
            "rows [z, speed] need the key direction, where it flows to; or give rows [z, speed, "
            "degrees]");
        return std::nullopt;
    }
    if (!given.direction->isZero(0.0)) return given.direction->stableNormalized();
    context.add_fault(given, given.direction, "expected a direction, found a vector of zero length");
    return std::nullopt;
}

// Appends a row as environment/flow_profile.hpp has it; the direction turns by the shorter way.
void add_flow_row(const std::vector<double>& row, SpeedProfile& profile) {
    profile.heights.push_back(row[0]);
    const bool has_turn = row.size() == 3;
    double turn = has_turn ? row[2] * std::numbers::pi / 180.0 : 0.0;
    if (has_turn && !profile.speeds.empty()) {
        const double last = profile.speeds.back();
        turn = last + std::remainder(turn - last, 2.0 * std::numbers::pi);
    }
    profile.speeds.insert(profile.speeds.end(), row.begin() + 1, row.end());
    if (has_turn) profile.speeds.back() = turn;
}

std::optional<SpeedProfile> find_profile(const FlowTable& given,
                                         const Acting& acting,
                                         const BuildContext& context) {
    const FlowRows& table = *given.table;
    SpeedProfile profile{.heights = {}, .speeds = {}};
    for (std::size_t i = 0; i < table.rows.size(); ++i) {
        const double height = table.rows[i][0];
        if (i > 0 && height <= profile.heights.back()) {
            context.faults.add(
                table.places[i],
                fmt::format("{}[{}]", given.path_of(&given.table), i),
                fmt::format("z must rise from row to row: {} follows {}", height, profile.heights.back()));
            return std::nullopt;
        }
        add_flow_row(table.rows[i], profile);
    }
    const std::optional<Vec3> direction = find_flow_direction(given, context);
    if (!direction) return std::nullopt;
    profile.direction = *direction;
    profile.factor = acting.apply(TimeFunction(1.0));
    return profile;
}

// A factor of its case is that of its forces, which the velocity does not have: see build_surroundings.
Flow find_flow(const std::optional<FlowTable>& given, const BuildContext& context) {
    if (!given) return {};
    Acting acting = find_acting(*given, context);
    acting.scale = 1.0;
    if (acting.is_absent) return {};
    Flow flow;
    if (given->table) {
        flow.profile = find_profile(*given, acting, context);
        return flow;
    }
    flow.field = [field = make_field(given->velocity->components, acting)](double time,
                                                                           const Vec3& position) -> Vec3 {
        const Vec3 uniform(field.uniform[0](time), field.uniform[1](time), field.uniform[2](time));
        return field.by_place ? Vec3(uniform + field.by_place(time, position)) : uniform;
    };
    return flow;
}

// A wind whose case has a factor: its forces are proportional to the density of the air.
double find_air_density(const AirTable& given, const BuildContext& context) {
    if (!given.wind || !acts_in_stage(*given.wind, context)) return given.density;
    const double factor = find_case_factor(given.wind->load_case, context);
    if (factor < 0.0)
        context.add_fault(
            *given.wind,
            given.wind->load_case,
            fmt::format("has the factor {:.6g} in the combination that acts; a wind cannot suck where "
                        "it blows: expected a factor of at least 0, and another wind for the other way",
                        factor));
    return factor > 0.0 ? factor * given.density : given.density;
}

Water find_water(const FluidTable& given, const SurroundingsFiles& files, const BuildContext& context) {
    Water water{.density = given.density};
    water.factor = find_presence(given, context);
    water.changes = given.factor || given.stages;
    check_added_mass(given, water.factor, context);
    water.surface = given.surface;
    water.depth = find_depth(given, context);
    water.current = find_flow(given.current, context);
    if (given.current) refuse_case_factor(*given.current, "the force of a current", context);
    water.stretching = given.stretching;
    water.stretches_current = given.current_stretching.value_or(false);
    set_waves(files, water, context);
    if (!water.waves.empty()) water.ramp = given.ramp;
    return water;
}

}  // namespace

void build_surroundings(const SurroundingsFiles& files, BuildContext& context) {
    const CheckedTable& deck = context.deck;
    if (context.stage == 0) check_surroundings(context);
    Surroundings& around = context.model.surroundings;
    for (const FluidTable& given : tables_of<FluidTable>(deck, fluid_table()))
        around.water = find_water(given, files, context);
    for (const AirTable& given : tables_of<AirTable>(deck, air_table()))
        around.air = Air{find_air_density(given, context), find_flow(given.wind, context)};
    for (const SeabedTable& given : tables_of<SeabedTable>(deck, seabed_table()))
        around.seabed = find_seabed(given, files.ground, context);
}

}  // namespace gxrod
