#include "deck/surroundings/build_seabed.hpp"

namespace gxrod {
namespace {

void set_plane(const CheckedTable& table, Seabed& seabed, const BuildContext& context) {
    seabed.point = table.get<Vec3>("point");
    const Vec3& normal = table.get<Vec3>("normal");
    if (normal.isZero(0.0))
        return context.add_fault(table, "normal", "expected a direction, found a vector of zero length");
    seabed.normal = normal.stableNormalized();
}

void set_friction(const CheckedTable& table, Seabed& seabed) {
    if (!table.gives("friction")) return;
    seabed.friction_stiffness = seabed.stiffness;
    if (const auto* both = std::get_if<double>(&table.find("friction")->value)) {
        seabed.axial_friction = seabed.lateral_friction = *both;
        return;
    }
    const CheckedTable& friction = table.tables("friction").front();
    seabed.axial_friction = friction.get<double>("axial");
    seabed.lateral_friction = friction.get<double>("lateral");
    if (friction.gives("stiffness")) seabed.friction_stiffness = friction.get<double>("stiffness");
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
    set_friction(table, seabed);
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
