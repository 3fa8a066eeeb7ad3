#include <algorithm>
#include <cmath>

#include "model/ties/yielding_supports.hpp"
#include "rotation/rotation_map.hpp"
#include "watch/quantity_tables.hpp"

namespace gxrod {
namespace {

std::string lacks_support(const Watched& target, const Model& model) {
    const int node = node_of(target);
    const bool is_held = std::ranges::find(model.supports, node, &Support::node) != model.supports.end();
    return is_held || yields_at(model, node) ? ""
                                             : "only a supported point has it; no [[support]] is at this one";
}

double find_no_load_angle(const Sight& see) {
    const SeenPoint seen = see.point();
    const Vec3 axis = seen.axes() * Vec3::UnitX();
    const Vec3 direction = see.of.no_load ? *see.of.no_load : Vec3(seen.start_axes * Vec3::UnitX());
    return std::atan2(direction.cross(axis).norm(), direction.dot(axis));
}

// clang-format off
constexpr Quantity place_lines[]{
    Quantity("position", "position", "length", Axes::observer,
             [](const Sight& see) { return see.point().motion.r; }).sized(Size::place),
    Quantity("displacement", "displacement since t = 0", "length", Axes::observer,
             [](const Sight& see) { return see.point().displacement(); }).sized(Size::change)};

constexpr Quantity rod_turn_lines[]{
    Quantity("rotation_vector",
             "rotation vector, at most pi long: since the reference configuration", "angle", Axes::observer,
             [](const Sight& see) { return log(see.point().motion.Lambda); })
        .turns(Turning::rotation_since_start,
               "rotation vector, at most pi long: since t = 0, as seen from the axes of {}")
        .followed_as("quaternion"),
    Quantity("quaternion", "unit quaternion w x y z: since the reference configuration", "1", Axes::observer,
             [](const Sight& see) { return see.point().motion.Lambda; })
        .turns(Turning::rotation_since_start, "unit quaternion w x y z: since t = 0, as seen from the axes of {}"),
    Quantity("orientation", "unit quaternion w x y z: section axes from the global axes", "1", Axes::observer,
             [](const Sight& see) { return see.point().axes(); })
        .turns(Turning::attitude, "unit quaternion w x y z: section axes from the axes of {}"),
    Quantity("axis_x", "x axis of the section, which points along the rod", "1", Axes::observer,
             [](const Sight& see) { return Vec3(see.point().axes() * Vec3::UnitX()); }),
    Quantity("no_load_angle", "angle of the rod's axis to the direction no_load, or to its own at t = 0", "angle", Axes::none,
             [](const Sight& see) { return find_no_load_angle(see); }).from_no_load()};

constexpr Quantity body_turn_lines[]{
    Quantity("rotation_vector",
             "rotation vector, at most pi long: body axes from the global axes", "angle", Axes::observer,
             [](const Sight& see) { return log(see.point().axes()); })
        .turns(Turning::attitude, "rotation vector, at most pi long: body axes from the axes of {}")
        .followed_as("quaternion"),
    Quantity("quaternion", "unit quaternion w x y z: body axes from the global axes", "1", Axes::observer,
             [](const Sight& see) { return see.point().axes(); })
        .turns(Turning::attitude, "unit quaternion w x y z: body axes from the axes of {}"),
    Quantity("orientation", "unit quaternion w x y z: body axes from the global axes", "1", Axes::observer,
             [](const Sight& see) { return see.point().axes(); })
        .turns(Turning::attitude, "unit quaternion w x y z: body axes from the axes of {}")};

constexpr Quantity rate_lines[]{
    Quantity("velocity", "velocity", "length/time", Axes::observer,
             [](const Sight& see) { return see.point().motion.v; }),
    Quantity("angular_velocity", "angular velocity", "angle/time", Axes::observer,
             [](const Sight& see) { return see.point().motion.omega; }),
    Quantity("angular_velocity_material", "angular velocity in the section or body axes", "angle/time", Axes::material,
             [](const Sight& see) { return see.point().material_spin(); }),
    Quantity("acceleration", "acceleration of the node", "length/time²", Axes::observer,
             [](const Sight& see) { return see.point().motion.a; })};

constexpr Quantity body_lines[]{
    Quantity("centre_of_mass", "position of the centre of mass", "length", Axes::observer,
             [](const Sight& see) { return see.centre_of_mass(); }).sized(Size::place)};

constexpr Quantity reaction_lines[]{
    Quantity("reaction_force", "force that the support exerts", "force", Axes::global,
             [](const Sight& see) { return see.reaction_force(); }).unless(lacks_support),
    Quantity("reaction_moment", "moment that the support exerts", "force·length", Axes::global,
             [](const Sight& see) { return see.reaction_moment(); }).unless(lacks_support).about_a_point()};
// clang-format on

}  // namespace

constinit const QuantityTable quantities_of_places{place_lines, SnapshotPart::motion, "points"};
constinit const QuantityTable quantities_of_rod_turns{rod_turn_lines, SnapshotPart::motion, "points"};
constinit const QuantityTable quantities_of_body_turns{body_turn_lines, SnapshotPart::motion, "points"};
constinit const QuantityTable quantities_of_rates{rate_lines, SnapshotPart::motion, "points"};
constinit const QuantityTable quantities_of_bodies{body_lines, SnapshotPart::motion, "points"};
constinit const QuantityTable quantities_of_reactions{reaction_lines, SnapshotPart::reactions, "points"};

}  // namespace gxrod
