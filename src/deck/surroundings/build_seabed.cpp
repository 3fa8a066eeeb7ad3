#include "deck/surroundings/build_seabed.hpp"

#include <algorithm>

#include "deck/loads/acting.hpp"

namespace gxrod {
namespace {

void set_plane(const CheckedTable& table, Seabed& seabed, const BuildContext& context) {
    seabed.point = table.get<Vec3>("point");
    const Vec3& normal = table.get<Vec3>("normal");
    if (normal.isZero(0.0))
        return context.add_fault(table, "normal", "expected a direction, found a vector of zero length");
    seabed.normal = normal.stableNormalized();
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
void set_friction(const CheckedTable& table, Seabed& seabed, const BuildContext& context) {
    if (!table.gives("friction")) return;
    double axial = 0.0, lateral = 0.0, stiffness = seabed.stiffness;
    bool acts = !finds_start(context);
    if (const auto* both = std::get_if<double>(&table.find("friction")->value)) {
        axial = lateral = *both;
    } else {
        const CheckedTable& friction = table.tables("friction").front();
        axial = friction.get<double>("axial");
        lateral = friction.get<double>("lateral");
        if (friction.gives("stiffness")) stiffness = friction.get<double>("stiffness");
        if (friction.gives("stages")) acts = acts_in_stage(friction, context);
    }
    if (axial == 0.0 && lateral == 0.0) return;
    seabed.friction_stiffness = stiffness;
    if (!acts) return;
    seabed.axial_friction = axial;
    seabed.lateral_friction = lateral;
}

}  // namespace

Seabed find_seabed(const CheckedTable& table,
                   const std::optional<GroundGrid>& grid,
                   const BuildContext& context) {
    Seabed seabed;
    if (table.gives("z")) seabed.point = Vec3(0.0, 0.0, table.get<double>("z"));
    if (table.gives("plane")) set_plane(table.tables("plane").front(), seabed, context);
    if (table.gives("grid")) seabed.grid = grid;
    seabed.stiffness = table.get<double>("stiffness");
    seabed.damping = table.get<double>("damping");
    set_friction(table, seabed, context);
    return seabed;
}

std::optional<double> find_bed_height(const CheckedTable& deck) {
    for (const CheckedTable& seabed : deck.tables("seabed")) {
        if (seabed.gives("z")) return seabed.get<double>("z");
        for (const CheckedTable& plane : seabed.tables("plane")) {
            const Vec3& normal = plane.get<Vec3>("normal");
            if (normal.x() == 0.0 && normal.y() == 0.0) return plane.get<Vec3>("point").z();
        }
    }
    return std::nullopt;
}

}  // namespace gxrod
