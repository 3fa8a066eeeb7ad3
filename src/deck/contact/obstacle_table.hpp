#pragma once

#include <optional>
#include <string>

#include "deck/contact/friction_table.hpp"
#include "deck/places/build_context.hpp"
#include "deck/rods/curve_table.hpp"
#include "deck/schema/choices.hpp"
#include "deck/supports/support_merge.hpp"
#include "deck/table/kinds.hpp"

// [obstacle.NAME].
namespace gxrod {

struct PlaneObstacleTable : TableHead {
    Vec3 point = Vec3::Zero();
    Vec3 normal = Vec3::Zero();
};

struct SphereObstacleTable : TableHead {
    Vec3 centre = Vec3::Zero();
    double radius = 0.0;
    ObstacleSide side = ObstacleSide::outside;
};

struct CylinderObstacleTable : TableHead {
    Vec3 from = Vec3::Zero();
    Vec3 to = Vec3::Zero();
    double radius = 0.0;
    ObstacleSide side = ObstacleSide::outside;
};

struct TubeObstacleTable : CurveTable {
    double radius = 0.0;
    ObstacleSide side = ObstacleSide::outside;
};

struct MeshObstacleTable : TableHead {
    std::string file;
    double scale = 1.0;
    std::optional<double> feature_angle{};
    bool smooth = false;
};

struct ObstacleMoveTable : MoveTable {
    Vec3 about = Vec3::Zero();
};

struct ObstacleTable : TableHead {
    std::optional<PlaneObstacleTable> plane;
    std::optional<SphereObstacleTable> sphere;
    std::optional<CylinderObstacleTable> cylinder;
    std::optional<TubeObstacleTable> tube;
    std::optional<MeshObstacleTable> mesh;
    ContactFrictionKey friction;
    std::optional<double> restitution;
    std::optional<double> stiffness;
    std::optional<ObstacleMoveTable> move;
};

// Adds the obstacles to the contact, with their motions in the current stage.
void build_obstacles(Contact& contact, const BuildContext& context);

// Adds faults for hollow obstacles that rods do not fit into. Call it once the contact has its exceptions.
void check_rooms(const BuildContext& context);

}  // namespace gxrod
