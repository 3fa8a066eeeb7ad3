#pragma once

#include "deck/places/build_context.hpp"
#include "deck/reading/copies.hpp"

namespace gxrod {

// A shape with which a body touches; it can have several.
struct BodyShapeTable : TableHead {
    double radius = 0.0;
    std::optional<double> force;
};

struct BodySphereTable : BodyShapeTable {
    Vec3 centre = Vec3::Zero();
};

struct BodyCapsuleTable : BodyShapeTable {
    Vec3 from = Vec3::Zero();
    Vec3 to = Vec3::Zero();
};

struct BodyFluidTable : TableHead {
    double volume = 0.0;
    Vec3 centre_of_buoyancy = Vec3::Zero();
    std::optional<double> height;
    Vec3 drag_area = Vec3::Zero();
    double drag_coefficient = 1.0;
    std::optional<Vec3> added_mass;
    std::optional<Mat6> added_mass_matrix;
};

struct BodyTable : TableHead {
    std::optional<double> mass;
    std::optional<std::variant<Vec3, Mat3>> inertia;
    std::variant<Vec3, PointName> at = Vec3(Vec3::Zero());
    Vec3 centre_of_mass = Vec3::Zero();
    Vec3 rotation_vector = Vec3::Zero();
    Vec3 velocity = Vec3::Zero();
    Vec3 angular_velocity = Vec3::Zero();
    std::optional<Vec3> angular_velocity_material;
    std::vector<BodySphereTable> spheres;
    std::vector<BodyCapsuleTable> capsules;
    std::optional<BodyFluidTable> fluid;
    Copies copies;
};

// Adds the bodies to the model, with nodes for those that are not on a rod, and their velocities to their
// nodes. After build_rods.
void build_bodies(BuildContext& context);

}  // namespace gxrod
