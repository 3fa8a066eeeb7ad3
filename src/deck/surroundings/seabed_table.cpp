#include "deck/surroundings/build_seabed.hpp"

#include <algorithm>

#include "deck/schema/schema_tables.hpp"
#include "deck/surroundings/presence.hpp"

namespace gxrod {
namespace {

const TableSpec& plane_table() {
    using T = BedPlaneTable;
    // clang-format off
    static const TableSpec table = Table<T>("seabed.plane", "")
        .key("point", &T::point, "A point of the ground.")
            .unit("length").required()
        .key("normal", &T::normal, "Out of the ground, of any length.")
            .unit("1").required();
    // clang-format on
    return table;
}

const TableSpec& grid_table() {
    // clang-format off
    static const TableSpec table = Table<BedGridTable>("seabed.grid", "")
        .key("file", &BedGridTable::file, "A CSV file of three columns, x, y and z, a row for each point of a grid in "
             "x and y, in any order; relative to the deck's folder.")
            .required();
    // clang-format on
    return table;
}

const TableSpec& bed_friction_table() {
    using T = BedFrictionTable;
    // clang-format off
    static const TableSpec table = Table<T>("seabed.friction", "")
        .key("axial", &T::axial, "Coulomb's coefficient along a rod.")
            .unit("1").at_least(0).required()
        .key("lateral", &T::lateral, "Across it.")
            .unit("1").at_least(0).required()
        .key("stiffness", &T::stiffness, "Force per area and displacement until it slides.")
            .unit("mass/(length²·time²)").above(0).otherwise("stiffness of the ground")
        .key("stages", &T::stages, "The stages in which it acts; in others what lies slides freely, and friction that "
             "begins later holds it where it is then.")
            .otherwise("all but a first static one that others follow").names_of({"stage"});
    // clang-format on
    return table;
}

}  // namespace

const TableSpec& seabed_table() {
    using T = SeabedTable;
    // clang-format off
    static const TableSpec table = Table<T>("[seabed]",
            "Ground, under water or not, that sections and bodies with a key `fluid` lie on.")
        .key("z", &T::z, "The height of a horizontal plane.")
            .unit("length").also("height level depth")
        .key("plane", &T::plane, plane_table(), "A plane that is not.")
        .key("grid", &T::grid, grid_table(), "Heights on a grid, linear between its points.")
            .also("file bathymetry table")
        .key("stiffness", &T::stiffness, "Force per area and depth; the area is the diameter times the length.")
            .unit("mass/(length²·time²)").above(0).required().also("k kb kbot normal_stiffness")
        .key("damping", &T::damping, "Force per area and speed, into the ground only.")
            .unit("mass/(length²·time)").at_least(0).also("c cb cbot")
        .key("friction", &T::friction, bed_friction_table(),
             "Coulomb's. A number is the coefficient along and across a rod.")
            .unit("1").at_least(0).otherwise("0").also("mu friction_coefficient")
        .key("factor", &T::factor, "What the force of the ground is multiplied by: its stiffness, damping and friction. "
             "By t of a stage, or by stage: a stage that is not named keeps the last value, and before the first one "
             "there is no ground.")
            .unit("1").otherwise("1")
        .key("stages", &T::stages, "The stages in which there is ground.")
            .otherwise("all").names_of({"stage"})
        .exactly_one_of({"z", "plane", "grid"})
        .shown_by(
            "[seabed]\n"
            "z         = -80\n"
            "stiffness = 1e5\n"
            "friction  = { axial = 0.3, lateral = 0.6 }\n");
    // clang-format on
    return table;
}

namespace {

void set_plane(const BedPlaneTable& given, Seabed& seabed, const BuildContext& context) {
    seabed.point = given.point;
    if (given.normal.isZero(0.0))
        return context.add_fault(given, given.normal, "expected a direction, found a vector of zero length");
    seabed.normal = given.normal.stableNormalized();
}

// Whether the stage at hand is a first static one that other stages with steps follow: there lines find where
// they rest.
bool finds_start(const BuildContext& context) {
    const auto moves = [](const StagePlan& stage) { return has_steps(stage.analysis); };
    const auto first = std::ranges::find_if(context.stages, moves);
    if (first == context.stages.end() || !std::holds_alternative<StaticSettings>(first->analysis))
        return false;
    return context.stages.begin() + static_cast<std::ptrdiff_t>(context.stage) <= first &&
           std::any_of(first + 1, context.stages.end(), moves);
}

// A stage in which friction does not act has no coefficients and keeps the stiffness: what touches then
// remembers its place as the one to which friction pulls in the next stage.
void set_friction(const SeabedTable& given, Seabed& seabed, const BuildContext& context) {
    if (!given.friction) return;
    double axial = 0.0, lateral = 0.0, stiffness = seabed.stiffness;
    bool acts = !finds_start(context);
    if (const auto* both = std::get_if<double>(&*given.friction)) {
        axial = lateral = *both;
    } else {
        const auto& friction = std::get<BedFrictionTable>(*given.friction);
        axial = friction.axial;
        lateral = friction.lateral;
        stiffness = friction.stiffness.value_or(stiffness);
        if (friction.stages) acts = acts_in_stage(friction, context);
    }
    if (axial == 0.0 && lateral == 0.0) return;
    seabed.friction_stiffness = stiffness;
    if (!acts) return;
    seabed.axial_friction = axial;
    seabed.lateral_friction = lateral;
}

}  // namespace

Seabed find_seabed(const SeabedTable& given,
                   const std::optional<GroundGrid>& grid,
                   const BuildContext& context) {
    Seabed seabed;
    if (given.z) seabed.point = Vec3(0.0, 0.0, *given.z);
    if (given.plane) set_plane(*given.plane, seabed, context);
    if (given.grid) seabed.grid = grid;
    seabed.stiffness = given.stiffness;
    seabed.damping = given.damping;
    seabed.factor = find_presence(given, context);
    set_friction(given, seabed, context);
    return seabed;
}

std::optional<double> find_bed_height(const CheckedTable& deck) {
    for (const SeabedTable& given : tables_of<SeabedTable>(deck, seabed_table())) {
        if (given.z) return given.z;
        if (!given.plane) continue;
        const Vec3& normal = given.plane->normal;
        if (normal.x() == 0.0 && normal.y() == 0.0) return given.plane->point.z();
    }
    return std::nullopt;
}

}  // namespace gxrod
