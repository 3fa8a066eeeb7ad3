#pragma once

#include <optional>
#include <string>
#include <vector>

#include "deck/bodies/body_table.hpp"
#include "deck/schema/schema.hpp"

namespace gxrod {

// Turns and moves a part within its body.
struct LookPlaceTable : TableHead {
    Vec3 at = Vec3::Zero();
    Vec3 rotation_vector = Vec3::Zero();
};

struct LookBoxTable : LookPlaceTable {
    Vec3 size = Vec3::Zero();
};

struct LookCylinderTable : TableHead {
    Vec3 from = Vec3::Zero();
    Vec3 to = Vec3::Zero();
    double radius = 0.0;
};

struct LookSphereTable : TableHead {
    Vec3 centre = Vec3::Zero();
    double radius = 0.0;
};

struct LookMeshTable : LookPlaceTable {
    std::string file;
    double scale = 1.0;
};

// A part of what a body looks like.
struct LookTable : TableHead {
    std::optional<LookBoxTable> box;
    std::optional<LookCylinderTable> cylinder;
    std::optional<LookSphereTable> sphere;
    std::optional<double> arms;  // their radius
    std::optional<LookMeshTable> mesh;
};

// [body.NAME] with its looks. What has forces reads it as a BodyTable, without them.
struct DrawnBodyTable : BodyTable {
    std::vector<LookTable> looks;
};

// Returns the keys of a part.
const TableSpec& look_table();

}  // namespace gxrod
