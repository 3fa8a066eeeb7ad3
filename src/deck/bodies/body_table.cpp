#include "deck/bodies/body_table.hpp"

#include <fmt/format.h>

#include "deck/bodies/looks_table.hpp"
#include "deck/schema/schema_tables.hpp"
#include "deck/surroundings/body_fluid.hpp"
#include "model/body_moments.hpp"
#include "numerics/eigenvalues.hpp"
#include "rotation/rotation_map.hpp"

namespace gxrod {
namespace {

// Relative to the largest entry: asymmetry of a matrix and excess of a principal moment that are round-off.
constexpr double round_off = 1e-9;
// A principal moment below this, relative to the largest, is zero.
constexpr double smallest_moment = 1e-15;

// Adds the key that both shapes have.
template <class T>
TableSpec with_force(Table<T> table) {
    return table
        .key("force",
             &T::force,
             "Of contact that leaves half the skin. By default the largest of 1000 weights, what stops it "
             "from "
             "its velocity at t = 0 within the skin, and EA/1000 of the rods that touch.")
        .unit("force")
        .above(0)
        .otherwise("1000 weights or more");
}

const TableSpec& sphere_table() {
    using T = BodySphereTable;
    // clang-format off
    static const TableSpec table = with_force(Table<T>("body.NAME.sphere", "")
        .key("radius", &T::radius, "Its own.")
            .unit("length").above(0).required()
        .key("centre", &T::centre, "From the node, body axes.")
            .unit("length"));
    // clang-format on
    return table;
}

const TableSpec& capsule_table() {
    using T = BodyCapsuleTable;
    // clang-format off
    static const TableSpec table = with_force(Table<T>("body.NAME.capsule", "")
        .key("from", &T::from, "An end of the segment, from the node, body axes.")
            .unit("length").required()
        .key("to", &T::to, "The other one.")
            .unit("length").required()
        .key("radius", &T::radius, "Of what is around the segment.")
            .unit("length").above(0).required());
    // clang-format on
    return table;
}

const TableSpec& fluid_of_body_table() {
    using T = BodyFluidTable;
    // clang-format off
    static const TableSpec table = Table<T>("body.NAME.fluid", "")
        .key("volume", &T::volume, "That displaces water.")
            .unit("length³").at_least(0).required().also("displacement v displaced_volume")
        .key("centre_of_buoyancy", &T::centre_of_buoyancy,
             "From the node, body axes: where buoyancy and the other forces act.")
            .unit("length").also("cob center_of_buoyancy")
        .key("height", &T::height, "Over which it sinks in, even along it and half of it below the centre of buoyancy.")
            .unit("length").above(0).otherwise("diameter of a sphere of the volume")
        .key("drag_area", &T::drag_area, "Seen along x, y and z of the body axes.")
            .unit("length²").at_least(0).also("area areas drag")
        .key("drag_coefficient", &T::drag_coefficient, "Of these areas.")
            .unit("1").at_least(0).also("cd")
        .key("added_mass", &T::added_mass, "Along x, y and z of the body axes.")
            .unit("mass").at_least(0).otherwise("[0, 0, 0]")
        .key("added_mass_matrix", &T::added_mass_matrix,
             "The same with rotations, about the centre of buoyancy, order x y z rx ry rz; symmetric and not negative.")
            .unit("of inertia").otherwise("what added_mass says")
        .at_most_one_of({"added_mass", "added_mass_matrix"});
    // clang-format on
    return table;
}

}  // namespace

const TableSpec& body_table() {
    using T = DrawnBodyTable;
    // clang-format off
    static const TableSpec table = Table<T>("[body.NAME]",
            "A rigid body fixed to a node. Its axes at t = 0 are the global axes turned by rotation_vector. `at`, "
            "velocities and loads refer to the node, not to the centre of mass.")
        .key("mass", &T::mass, "Mass.")
            .unit("mass").above(0).otherwise("0 if static, else required").also("m")
        .key("inertia", &T::inertia, "About the centre of mass, body axes: 3 principal moments or a symmetric 3×3 "
             "matrix; no principal moment above the sum of the others. Where the body has a node of its own in a "
             "dynamic analysis, positive definite.")
            .unit("mass·length²").otherwise("0 if static or at a rod's point, else required")
            .also("j i moment_of_inertia moments_of_inertia inertia_tensor")
        .key("at", &T::at, "Where its node is; or a rod's point, whose node it then shares.")
            .unit("length").also("position pos x location origin point node")
        .key("centre_of_mass", &T::centre_of_mass, "From the node, body axes.")
            .unit("length").also("com cog cm center_of_gravity centre_of_gravity")
        .key("rotation_vector", &T::rotation_vector, "The attitude at t = 0.")
            .unit("angle").also("rotation orientation attitude rotation_angle")
        .key("velocity", &T::velocity, "Of the node at t = 0, global components.")
            .unit("length/time").also("v initial_velocity")
        .key("angular_velocity", &T::angular_velocity, "At t = 0, global components.")
            .unit("angle/time").also("omega w spin rotation_rate initial_angular_velocity")
        .key("angular_velocity_material", &T::angular_velocity_material, "At t = 0, components in the body axes.")
            .unit("angle/time").otherwise("what angular_velocity says")
        .key("sphere", &T::spheres, sphere_table(),
             "With which it touches every [obstacle.NAME], and rods and other bodies if there is [contact]. Spheres "
             "and capsules together are one body; they do not touch each other.")
            .or_one().also("spheres ball balls collision contact")
        .key("capsule", &T::capsules, capsule_table(), "The same: all within a radius of a segment.")
            .or_one().also("capsules")
        .key("fluid", &T::fluid, fluid_of_body_table(),
             "What [fluid] and [air] see of it. Without it they pass it by. The ground does not touch bodies.")
            .also("hydro drag buoyancy volume")
        .key("looks", &T::looks, look_table(), "What it looks like in reports and pictures, part by part; no "
             "force depends on it. Without it the spheres and capsules of contact, or the cuboid of its mass and inertia, "
             "and lines to its joints.")
            .also("shape outline shapes geometry graphics visual appearance")
        .with(add_copies<T>)
        .not_here("force moment torque load", "a [[load]] at the body has its forces and moments")
        .at_most_one_of({"angular_velocity", "angular_velocity_material"})
        .shown_by(
            "[body.gyroscope]\n"
            "mass            = 1.0\n"
            "inertia         = [1.0, 1.0, 0.75]\n"
            "at              = [0, 0, 0]\n"
            "centre_of_mass  = [0, 0, 0.5]\n"
            "rotation_vector = [0, \"pi/3\", 0]\n"
            "angular_velocity_material = [0, 0, 50]\n");
    // clang-format on
    return table;
}

namespace {

Mat3 inertia_of(const std::variant<Vec3, Mat3>& given) {
    if (const auto* principal = std::get_if<Vec3>(&given)) return principal->asDiagonal();
    return std::get<Mat3>(given);
}

// What an analysis asks of the inertia of a body.
enum class Need { any, definite };

// Why a body cannot have these principal moments, in rising order; "" if it can.
std::string explain_moments(const Vec3& moments, Need need) {
    const double size = moments.cwiseAbs().maxCoeff();
    const std::string principal = fmt::format("{:.6g}, {:.6g}, {:.6g}", moments[0], moments[1], moments[2]);
    if (need == Need::definite && !(moments[0] > smallest_moment * size)) {
        return "expected a positive definite inertia, found principal moments " + principal +
               "; a rotation without inertia cannot be integrated in time";
    }
    if (moments[0] < -round_off * size) {
        return "expected principal moments that are not negative, found " + principal;
    }
    if (is_beyond_rounding(moments)) {
        return fmt::format(
            "no body has the principal moments {}: the largest cannot be above the sum of the others; "
            "expected "
            "{:.6g} at most, or greater values of the others",
            principal,
            moments[0] + moments[1]);
    }
    return "";
}

// A node of the body's own has no other inertia, which a dynamic analysis needs.
Need find_need(const BodyTable& given, const BuildContext& context) {
    const bool has_own_node = std::holds_alternative<Vec3>(given.at);
    return has_own_node && context.needs_inertia() ? Need::definite : Need::any;
}

// The inertia, if a rigid body can have it.
std::optional<Mat3> find_inertia(const BodyTable& body, const BuildContext& context) {
    if (!body.inertia) {
        if (find_need(body, context) == Need::definite) {
            context.add_fault(body,
                              body.inertia,
                              fmt::format("missing; expected {}; a rotation without inertia cannot be "
                                          "integrated in time",
                                          describe_expected(body.key_of(&body.inertia))));
        }
        return Mat3(Mat3::Zero());
    }
    const Mat3 given = inertia_of(*body.inertia);
    const double size = given.cwiseAbs().maxCoeff();
    if ((given - given.transpose()).cwiseAbs().maxCoeff() > round_off * size) {
        context.add_fault(body, body.inertia, "expected a symmetric matrix");
        return std::nullopt;
    }
    const Mat3 inertia = 0.5 * (given + given.transpose());
    const std::string reason =
        explain_moments(find_symmetric_eigen(inertia).values, find_need(body, context));
    if (reason.empty()) return inertia;
    context.add_fault(body, body.inertia, reason);
    return std::nullopt;
}

// 0 where a static analysis has none.
double find_mass(const BodyTable& body, const BuildContext& context) {
    if (body.mass) return *body.mass;
    if (context.needs_inertia()) {
        context.add_fault(body, body.mass, "missing; expected " + describe_expected(body.key_of(&body.mass)));
    }
    return 0.0;
}

// The node of a body: that of a rod's point, or a new one. -1 if the rod has no mesh.
int find_node(const BodyTable& body, BuildContext& context) {
    if (const auto* point = std::get_if<PointName>(&body.at)) {
        const std::optional<PlacedPoint> placed = context.place(point->word);
        return placed ? placed->node : -1;
    }
    context.model.nodes.push_back({body.name, std::get<Vec3>(body.at)});
    return static_cast<int>(context.model.nodes.size()) - 1;
}

// `velocity` of the body, one of its fields or made of one, becomes the motion of its node.
template <class Field>
void set_motion(const BodyTable& body,
                const Field& field,
                const Vec3& velocity,
                VelocitySetting& record,
                Vec3& motion,
                const BuildContext& context) {
    if (!body.gives(field)) return;
    if (!context.has_velocities())
        return context.reject_velocities(body.place_of(&field), body.path_of(&field));
    if (record.table != nullptr) {
        const std::string message = record.table->path + " is at the same node and sets it too";
        return context.add_fault(body, field, message);
    }
    record = {&body, &field, velocity.norm()};
    motion = velocity;
}

void set_velocities(const BodyTable& given, const Body& body, BuildContext& context) {
    auto& [velocity, spin] = context.velocity_settings[body.node];
    Node& node = context.model.nodes[body.node];
    set_motion(given, given.velocity, given.velocity, velocity, node.velocity, context);
    set_motion(given, given.angular_velocity, given.angular_velocity, spin, node.angular_velocity, context);
    const std::optional<Vec3>& material = given.angular_velocity_material;
    if (material)
        set_motion(given, material, body.attitude * *material, spin, node.angular_velocity, context);
}

}  // namespace

void build_bodies(BuildContext& context) {
    for (const BodyTable& given : tables_of<BodyTable>(context.deck, body_table())) {
        Body body{.name = given.name, .mass = find_mass(given, context)};
        body.inertia = find_inertia(given, context).value_or(Mat3::Identity());
        body.centre_of_mass = given.centre_of_mass;
        body.attitude = exp_quaternion(given.rotation_vector);
        if (given.fluid) body.fluid = find_body_fluid(*given.fluid, context);
        const int node = find_node(given, context);
        context.body_nodes.push_back(node);
        body.node = std::max(node, 0);
        context.model.bodies.push_back(body);
        context.velocity_settings.resize(context.model.nodes.size());
        if (node >= 0) set_velocities(given, body, context);
    }
}

}  // namespace gxrod
