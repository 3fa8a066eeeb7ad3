#include "deck/contact/obstacle_table.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "deck/checks/check_moves.hpp"
#include "deck/contact/build_contact_exceptions.hpp"
#include "deck/joints/ends.hpp"
#include "deck/loads/acting.hpp"
#include "deck/schema/schema_tables.hpp"
#include "deck/table/table.hpp"

namespace gxrod {
namespace {

const TableSpec& plane_obstacle_table() {
    using T = PlaneObstacleTable;
    // clang-format off
    static const TableSpec table = Table<T>("obstacle.NAME.plane", "")
        .key("point", &T::point, "A point of it.")
            .unit("length").required()
        .key("normal", &T::normal, "Towards the rods, of any length.")
            .unit("1").required();
    // clang-format on
    return table;
}

// Adds the keys that all round shapes have.
template <class T>
TableSpec with_round(Table<T> table, const std::string& sentence = "Its own.") {
    // clang-format off
    return table
        .key("radius", &T::radius, sentence)
            .unit("length").above(0).required()
        .key("side", &T::side, "Where the rods are.");
    // clang-format on
}

const TableSpec& sphere_obstacle_table() {
    using T = SphereObstacleTable;
    // clang-format off
    static const TableSpec table = with_round(Table<T>("obstacle.NAME.sphere", "")
        .key("centre", &T::centre, "Its centre.")
            .unit("length").required());
    // clang-format on
    return table;
}

const TableSpec& cylinder_obstacle_table() {
    using T = CylinderObstacleTable;
    // clang-format off
    static const TableSpec table = with_round(Table<T>("obstacle.NAME.cylinder", "")
        .key("from", &T::from, "A point of its axis, where it starts.")
            .unit("length").required()
        .key("to", &T::to, "Where it ends. It has ends like hemispheres; a hollow one has none.")
            .unit("length").required());
    // clang-format on
    return table;
}

const TableSpec& tube_obstacle_table() {
    static const TableSpec table = with_round(Table<TubeObstacleTable>("obstacle.NAME.tube", "")
                                                  .keys_of(curve_keys(), {"arc", "helix", "spline"})
                                                  .exactly_one_of({"arc", "helix", "spline"}),
                                              "Its own, inside if the rods are there.");
    return table;
}

const TableSpec& mesh_obstacle_table() {
    using T = MeshObstacleTable;
    // clang-format off
    static const TableSpec table = Table<T>("obstacle.NAME.mesh", "")
        .key("file", &T::file, "STL, as text or binary, or .msh of Gmsh. Relative to the deck's folder.")
            .required()
        .key("scale", &T::scale, "Times the coordinates of the file: 1e-3 for one in mm.")
            .unit("1").above(0)
        .key("feature_angle", &T::feature_angle,
             "Edges that turn by more are sharp: what is next to them is touched on its own.")
            .unit("angle").above(0).at_most(M_PI).otherwise("0.1; with smooth 0.6")
        .key("smooth", &T::smooth,
             "Whether facets stand for a curved surface: edges that are not sharp are rounded, through the corners.")
            .otherwise("false").also("round rounded smoothing");
    // clang-format on
    return table;
}

const TableSpec& obstacle_move_table() {
    using T = ObstacleMoveTable;
    // clang-format off
    static const TableSpec table = with_components(Table<T>("obstacle.NAME.move", ""))
        .key("about", &T::about, "The point about which it turns, at t = 0.")
            .unit("length")
        .at_least_one_of({"x", "y", "z", "rx", "ry", "rz"});
    // clang-format on
    return table;
}

}  // namespace

const TableSpec& obstacle_table() {
    using T = ObstacleTable;
    static const TableSpec friction = contact_friction_table("obstacle.NAME");
    // clang-format off
    static const TableSpec table = Table<T>("[obstacle.NAME]",
            "What does not deform, and what rods, and bodies with a sphere or capsule, touch and never pass.")
        .key("plane", &T::plane, plane_obstacle_table(), "A half space.")
            .also("floor wall half_space")
        .key("sphere", &T::sphere, sphere_obstacle_table(), "Solid, or hollow.")
            .also("ball")
        .key("cylinder", &T::cylinder, cylinder_obstacle_table(), "Solid, or hollow.")
            .also("pipe rod pulley drum")
        .key("tube", &T::tube, tube_obstacle_table(),
             "About a curve; its ends continue straight if it is hollow, else they are hemispheres.")
        .key("mesh", &T::mesh, mesh_obstacle_table(), "Triangles of a file, which stop rods on both sides.")
        .key("friction", &T::friction, friction, "Coulomb's coefficient.")
            .unit("1").at_least(0).otherwise("that of [contact]").also("mu friction_coefficient")
        .key("restitution", &T::restitution, "Coefficient of impacts, as in [contact].")
            .unit("1").above(0).at_most(1).otherwise("that of [contact]").also("e cor coefficient_of_restitution")
        .key("stiffness", &T::stiffness, "Of a bed that yields instead of a rigid body: force per length and depth.")
            .unit("force/length²").above(0).also("k penalty contact_stiffness")
        .key("move", &T::move, obstacle_move_table(),
             "Where it goes: exp of (rx, ry, rz), of any size, is its rotation since t = 0. 0 at t = 0.")
            .also("motion moves")
        .exactly_one_of({"plane", "sphere", "cylinder", "tube", "mesh"})
        .shown_by(
            "[obstacle.floor]\n"
            "plane = { point = [0, 0, -5], normal = [0, 0, 1] }\n");
    // clang-format on
    return table;
}

namespace {

Vec3 find_normal(const PlaneObstacleTable& plane, const BuildContext& context) {
    if (!plane.normal.isZero(0.0)) return plane.normal.stableNormalized();
    context.add_fault(plane, plane.normal, "expected a direction, found a vector of zero length");
    return Vec3::UnitZ();
}

// Points of a smooth curve so close that cubic pieces between them are the curve but for 1e-8 of its bends.
void set_curve(const CurveTable& table, TubeShape& tube, const BuildContext& context) {
    const std::optional<Centreline> line = find_centreline(table, context);
    if (!line) return;
    constexpr double most_turn = 0.05;
    const double turn = line->turn(0, 0.0, 1.0);
    const int pieces = std::max(8, static_cast<int>(std::ceil(turn / most_turn)));
    for (int i = 0; i <= pieces; ++i) {
        const double fraction = static_cast<double>(i) / pieces;
        tube.line.push_back(line->position(0, fraction));
        tube.tangents.push_back(line->transport(0, fraction) * line->start_tangent());
    }
}

// The radius and the side of a round shape.
template <class Shape, class Given>
Shape make_round(const Given& table) {
    Shape shape;
    shape.radius = table.radius;
    shape.is_hollow = table.side == ObstacleSide::inside;
    return shape;
}

ObstacleShape build_shape(const ObstacleTable& table, const BuildContext& context) {
    if (table.plane) return PlaneShape{table.plane->point, find_normal(*table.plane, context)};
    if (table.mesh) {
        if (table.stiffness)
            context.add_fault(table,
                              table.stiffness,
                              "a mesh does not yield, since neither side of it is inside; expected none");
        return MeshShape{context.obstacle_meshes.at(table.name)};
    }
    if (table.sphere) {
        auto sphere = make_round<SphereShape>(*table.sphere);
        sphere.centre = table.sphere->centre;
        return sphere;
    }
    if (table.cylinder) {
        const CylinderObstacleTable& given = *table.cylinder;
        auto cylinder = make_round<CylinderShape>(given);
        cylinder.from = given.from;
        cylinder.to = given.to;
        if (cylinder.from == cylinder.to)
            context.add_fault(given, given.to, "expected an end away from its start");
        return cylinder;
    }
    auto tube = make_round<TubeShape>(*table.tube);
    set_curve(*table.tube, tube, context);
    return tube;
}

void check_room(const ObstacleTable& table, std::size_t index, const BuildContext& context) {
    const Contact& contact = context.model.contact;
    const RoundShape* round = contact.obstacles[index].round();
    if (round == nullptr || !round->is_hollow) return;
    double thickest = 0.0;
    for (std::size_t rod = 0; rod < contact.radii.size(); ++rod) {
        if (!is_left_out(contact, static_cast<int>(rod), -1 - static_cast<int>(index)))
            thickest = std::max(thickest, contact.radii[rod]);
    }
    if (thickest < round->radius) return;
    context.faults.add(
        table.place,
        table.path,
        fmt::format("a rod of radius {:.6g} is to be inside, which is no narrower than its radius "
                    "{:.6g}",
                    thickest,
                    round->radius));
}

// A component of a motion in the stage at hand: f(t) after what earlier stages have moved.
TimeFunction continue_motion(const CheckedTimeFunction& given, const BuildContext& context) {
    std::vector<std::pair<TimeFunction, std::shared_ptr<const double>>> earlier;
    for (std::size_t i = 0; i < context.stage; ++i) {
        const StagePlan& stage = context.stages[i];
        if (has_steps(stage.analysis)) earlier.emplace_back(given.function, stage.end);
    }
    TimeFunction own = find_acting(context).apply(given.function);
    if (earlier.empty()) return own;
    return TimeFunction([own, earlier](double t) {
        double sum = own(t);
        for (const auto& [function, end] : earlier) sum += function(*end);
        return sum;
    });
}

ObstacleMotion build_motion(const ObstacleMoveTable& given, const BuildContext& context) {
    std::array<TimeFunction, 6> components;
    const double size = measure_size(context.model, {});
    for (std::size_t i = 0; i < 6; ++i) {
        if (!given.components[i]) continue;
        const CheckedTimeFunction& value = *given.components[i];
        if (context.stages.size() > 1 && !value.function.has_time()) {
            context.faults.add(
                value.place, value.path, "with several stages expected an expression of t, 0 at t = 0");
            continue;
        }
        check_move(value, i < 3 ? size : 1.0, context);
        components[i] = continue_motion(value, context);
    }
    return {TimeVector(std::array{components[0], components[1], components[2]}),
            TimeVector(std::array{components[3], components[4], components[5]}),
            given.about};
}

}  // namespace

void build_obstacles(Contact& contact, const BuildContext& context) {
    for (const ObstacleTable& given : tables_of<ObstacleTable>(context.deck, obstacle_table())) {
        Obstacle obstacle;
        obstacle.name = given.name;
        obstacle.shape = build_shape(given, context);
        const ContactFriction friction = given.friction
                                             ? find_contact_friction(given.friction, context)
                                             : ContactFriction{contact.friction, contact.friction_shape};
        obstacle.friction = friction.coefficient;
        obstacle.friction_shape = friction.shape;
        obstacle.stiffness = given.stiffness;
        if (given.move) obstacle.motion = build_motion(*given.move, context);
        contact.obstacles.push_back(std::move(obstacle));
    }
}

void check_rooms(const BuildContext& context) {
    std::size_t index = 0;
    for (const ObstacleTable& given : tables_of<ObstacleTable>(context.deck, obstacle_table()))
        check_room(given, index++, context);
}

}  // namespace gxrod
