#include <cmath>
#include <vector>

#include "deck/contact/obstacle_tables.hpp"
#include "deck/schema/choices.hpp"
#include "deck/schema/schema_tables.hpp"

// [contact] and [obstacle.NAME].
namespace gxrod {
namespace {

constexpr Range not_negative{.lower = 0.0};

KeySpec length_key(const char* name, const char* sentence) {
    return {.name = name,
            .type = ValueType::number,
            .dimension = "length",
            .range = positive,
            .presence = Presence::required,
            .sentence = sentence};
}

KeySpec vector_key(const char* name, const char* dimension, const char* sentence) {
    return {.name = name,
            .type = ValueType::vector,
            .dimension = dimension,
            .presence = Presence::required,
            .sentence = sentence};
}

KeySpec side_key() {
    return {.name = "side",
            .type = ValueType::choice,
            .default_value = "outside",
            .sentence = "Where the rods are.",
            .choices = words_of(obstacle_side_choices)};
}

const TableSpec& plane_obstacle_table() {
    static const TableSpec table{.path = "obstacle.NAME.plane",
                                 .heading = "plane = { … }",
                                 .sentence = "",
                                 .keys = {vector_key("point", "length", "A point of it."),
                                          vector_key("normal", "1", "Towards the rods, of any length.")}};
    return table;
}

const TableSpec& sphere_obstacle_table() {
    static const TableSpec table{
        .path = "obstacle.NAME.sphere",
        .heading = "sphere = { … }",
        .sentence = "",
        .keys = {
            vector_key("centre", "length", "Its centre."), length_key("radius", "Its own."), side_key()}};
    return table;
}

const TableSpec& cylinder_obstacle_table() {
    static const TableSpec table{
        .path = "obstacle.NAME.cylinder",
        .heading = "cylinder = { … }",
        .sentence = "",
        .keys = {
            vector_key("from", "length", "A point of its axis, where it starts."),
            vector_key("to", "length", "Where it ends. It has ends like hemispheres; a hollow one has none."),
            length_key("radius", "Its own."),
            side_key()}};
    return table;
}

const TableSpec& tube_obstacle_table() {
    using T = TubeObstacleTable;
    // clang-format off
    static const TableSpec table = Table<T>("obstacle.NAME.tube", "")
        .keys_of(curve_keys(), {"arc", "helix", "spline"})
        .key("radius", &T::radius, "Its own, inside if the rods are there.")
            .unit("length").above(0).required()
        .key("side", &T::side, "Where the rods are.")
        .exactly_one_of({"arc", "helix", "spline"});
    // clang-format on
    return table;
}

const TableSpec& mesh_obstacle_table() {
    static const TableSpec table{
        .path = "obstacle.NAME.mesh",
        .heading = "mesh = { … }",
        .sentence = "",
        .keys = {
            {.name = "file",
             .type = ValueType::text,
             .presence = Presence::required,
             .sentence = "STL, as text or binary, or .msh of Gmsh. Relative to the deck's folder."},
            {.name = "scale",
             .type = ValueType::number,
             .dimension = "1",
             .range = positive,
             .default_value = 1.0,
             .sentence = "Times the coordinates of the file: 1e-3 for one in mm."},
            {.name = "feature_angle",
             .type = ValueType::number,
             .dimension = "angle",
             .range = {.lower = 0.0, .at_lower = Bound::open, .upper = M_PI},
             .default_value = 0.1,
             .sentence = "Edges that turn by more are sharp: what is next to them is touched on its own."}}};
    return table;
}

const TableSpec& obstacle_move_table() {
    static const TableSpec table = [] {
        TableSpec move{.path = "obstacle.NAME.move", .heading = "move = { … }", .sentence = "", .keys = {}};
        for (std::size_t i = 0; i < component_names.size(); ++i) {
            const std::string axis(component_names[i].substr(component_names[i].size() - 1));
            move.keys.push_back({.name = std::string(component_names[i]),
                                 .type = ValueType::time_expression,
                                 .dimension = i < 3 ? "length" : "angle",
                                 .sentence = i < 3 ? "Displacement along " + axis + " since t = 0."
                                                   : "Component " + axis + " of the rotation vector."});
        }
        move.keys.push_back({.name = "about",
                             .type = ValueType::vector,
                             .dimension = "length",
                             .default_value = Vec3(0, 0, 0),
                             .sentence = "The point about which it turns, at t = 0."});
        move.groups = {{GroupRule::at_least_one, {"x", "y", "z", "rx", "ry", "rz"}}};
        return move;
    }();
    return table;
}

const TableSpec& contact_pair_table() {
    static const TableSpec table{
        .path = "contact.pair",
        .heading = "[[contact.pair]]",
        .sentence = "What is different for some of what touches; of those that fit, the last one counts.",
        .keys = {{.name = "between",
                  .type = ValueType::partners,
                  .presence = Presence::required,
                  .sentence =
                      "Rods and obstacles; a rod twice for what touches itself. Elements of the rod end "
                      "where a part of it ends; on a rod from a mesh a part ends where elements do."},
                 {.name = "friction",
                  .type = ValueType::number,
                  .dimension = "1",
                  .range = not_negative,
                  .sentence = "Coulomb's coefficient there."},
                 {.name = "off", .type = ValueType::flag, .sentence = "true: they pass through each other."}},
        .groups = {{GroupRule::exactly_one, {"friction", "off"}}}};
    return table;
}

KeySpec table_key(const char* name, const TableSpec& table, const char* sentence) {
    return {.name = name, .type = ValueType::table, .sentence = sentence, .table = &table};
}

std::vector<KeySpec> contact_keys() {
    return {{.name = "rods",
             .type = ValueType::names,
             .default_text = "all rods",
             .sentence = "Which rods touch; their sections have a radius.",
             .refers_to = {"rod"}},
            {.name = "each_other",
             .type = ValueType::flag,
             .default_text = "true",
             .sentence = "Whether different rods and bodies touch."},
            {.name = "self",
             .type = ValueType::flag,
             .default_text = "true",
             .sentence = "Whether a rod touches itself."},
            {.name = "bend_radius",
             .type = ValueType::number,
             .dimension = "length",
             .range = positive,
             .default_text = "10 radii",
             .sentence = "The tightest bend to expect of rods that touch each other: they touch as straight "
                         "pieces, so short that their chords stay within a quarter of the skin."},
            {.name = "friction",
             .type = ValueType::number,
             .dimension = "1",
             .range = not_negative,
             .default_value = 0.0,
             .sentence =
                 "Coulomb's coefficient of rods with each other, and of obstacles that have none of their "
                 "own, on the surface."},
            {.name = "skin",
             .type = ValueType::number,
             .dimension = "1",
             .range = {.lower = 0.0, .at_lower = Bound::open, .upper = 1.0},
             .default_value = 0.02,
             .sentence = "Contact acts below this gap, times the radius of the rod; no gap ever closes."},
            {.name = "dissipation",
             .type = ValueType::number,
             .dimension = "1",
             .range = {.lower = 0.0, .upper = 1.0},
             .default_value = 1.0,
             .sentence =
                 "Of impacts on obstacles: with 0 they keep their energy at every step size, with 1 contact "
                 "gives back least."},
            {.name = "damping",
             .type = ValueType::number,
             .dimension = "time/length",
             .range = not_negative,
             .default_value = 0.0,
             .sentence = "Of impacts: the force is multiplied by 1 − damping times the rate of the gap, and "
                         "never pulls. Next to `dissipation`, whose loss depends on the step."},
            {.name = "pair",
             .type = ValueType::table_list,
             .sentence = "Exceptions.",
             .table = &contact_pair_table()}};
}

}  // namespace

const TableSpec& contact_table() {
    static const TableSpec table{
        .path = "contact",
        .heading = "[contact]",
        .sentence =
            "Rods touch each other, themselves and every [obstacle.NAME]; without it obstacles alone. So do "
            "bodies with a sphere or capsule.",
        .keys = contact_keys(),
        .example =
            "[contact]\n"
            "rods       = [\"spring\", \"bow\"]\n"
            "each_other = false\n"
            "friction   = 0.3\n"
            "\n"
            "[[contact.pair]]\n"
            "between  = [\"bow\", \"floor\"]\n"
            "friction = 0.6\n"};
    return table;
}

const TableSpec& obstacle_table() {
    static const TableSpec table{
        .path = "obstacle.NAME",
        .heading = "[obstacle.NAME]",
        .sentence =
            "What does not deform, and what rods, and bodies with a sphere or capsule, touch and never pass.",
        .keys = {table_key("plane", plane_obstacle_table(), "A half space."),
                 table_key("sphere", sphere_obstacle_table(), "Solid, or hollow."),
                 table_key("cylinder", cylinder_obstacle_table(), "Solid, or hollow."),
                 table_key(
                     "tube",
                     tube_obstacle_table(),
                     "About a curve; its ends continue straight if it is hollow, else they are hemispheres."),
                 table_key(
                     "mesh", mesh_obstacle_table(), "Triangles of a file, which stop rods on both sides."),
                 {.name = "friction",
                  .type = ValueType::number,
                  .dimension = "1",
                  .range = not_negative,
                  .default_text = "that of [contact]",
                  .sentence = "Coulomb's coefficient."},
                 {.name = "stiffness",
                  .type = ValueType::number,
                  .dimension = "force/length²",
                  .range = positive,
                  .sentence = "Of a bed that yields instead of a rigid body: force per length and depth."},
                 table_key("move",
                           obstacle_move_table(),
                           "Where it goes: exp of (rx, ry, rz), of any size, is its rotation since t = 0. 0 "
                           "at t = 0.")},
        .groups = {{GroupRule::exactly_one, {"plane", "sphere", "cylinder", "tube", "mesh"}}},
        .example =
            "[obstacle.floor]\n"
            "plane = { point = [0, 0, -5], normal = [0, 0, 1] }\n"};
    return table;
}

}  // namespace gxrod
