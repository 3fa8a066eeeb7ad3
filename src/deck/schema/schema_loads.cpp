#include "deck/schema/choices.hpp"
#include "deck/schema/schema_tables.hpp"

// [[connect]], [[load]], [[support]] and [[initial]].
namespace gxrod {
namespace {

constexpr const char* force_dimension = "mass·length/time²";
constexpr const char* moment_dimension = "mass·length²/time²";
constexpr const char* force_per_length_dimension = "mass/time²";

std::vector<std::string> fix_words() {
    std::vector<std::string> words(component_names.begin(), component_names.end());
    words.insert(words.end(), {"all", "position", "rotation"});
    return words;
}

KeySpec load_vector(const char* name, const char* dimension, const char* with, const char* sentence) {
    const bool at_point = std::string_view(with) == "at";
    const ValueType along = at_point ? ValueType::time_vector : ValueType::line_vector;
    return {.name = name,
            .type = std::string_view(name) == "force" ? ValueType::motion_vector : along,
            .dimension = dimension,
            .default_text = "[0, 0, 0]",
            .sentence = sentence,
            .only_with = with};
}

std::vector<KeySpec> load_keys() {
    return {
        {.name = "at", .type = ValueType::point, .sentence = "A point of a rod, or a body."},
        {.name = "on",
         .type = ValueType::reference,
         .sentence = "The name of a rod, for a load along it.",
         .refers_to = {"rod"}},
        load_vector("force",
                    force_dimension,
                    "at",
                    "Force; x, y, z is where the point is then, vx, vy, vz how fast it moves, global."),
        load_vector("moment", moment_dimension, "at", "Moment."),
        load_vector("force_per_length",
                    force_per_length_dimension,
                    "on",
                    "Force per reference length; s is the arc length from the rod's start."),
        load_vector("moment_per_length",
                    force_dimension,
                    "on",
                    "Moment per reference length; s is the arc length from the rod's start."),
        {.name = "frame",
         .type = ValueType::choice,
         .default_value = word_of(frame_choices, NodalLoad{}.frame),
         .sentence = "spatial: fixed in space, a dead load. follower: global components at t = 0, turned "
                     "with the node or section. body: components in the section axes of the point named, "
                     "or along the rod (body axes of a body).",
         .choices = words_of(frame_choices)},
        factor_key("load"),
        {.name = "relative_to",
         .type = ValueType::choice,
         .default_text = "nothing",
         .sentence = "limit: for a stage with `follow`, where it begins to act: the load is its value times "
                     "the load factor of the limit point, and without t times t.",
         .choices = {"limit"}},
        stages_key("The stages in which the load acts.")};
}

const TableSpec& move_table() {
    static const TableSpec table = [] {
        TableSpec move{.path = "support.move", .heading = "move = { … }", .sentence = "", .keys = {}};
        for (std::size_t i = 0; i < component_names.size(); ++i) {
            const std::string axis(component_names[i].substr(component_names[i].size() - 1));
            move.keys.push_back({.name = std::string(component_names[i]),
                                 .type = ValueType::time_expression,
                                 .dimension = i < 3 ? "length" : "angle",
                                 .sentence = i < 3 ? "Displacement along " + axis + " since t = 0."
                                                   : "Component " + axis + " of the rotation vector."});
        }
        return move;
    }();
    return table;
}

}  // namespace

KeySpec stages_key(const char* sentence) {
    return {.name = "stages",
            .type = ValueType::names,
            .default_text = "all",
            .sentence = sentence,
            .refers_to = {"stage"}};
}

KeySpec factor_key(const std::string& what) {
    return {.name = "factor",
            .type = ValueType::stage_functions,
            .dimension = "1",
            .default_text = "1; t in the first stage if that is static and the value has no t",
            .sentence = "What the " + what +
                        " is multiplied by, in a stage's own t. By stage: a stage that is not "
                        "named keeps the last value, and before the first one there is no " +
                        what + "."};
}

const TableSpec& connect_table() {
    static const TableSpec table{
        .path = "connect",
        .heading = "[[connect]]",
        .sentence =
            "Points of rods that become one node, a rigid corner. Rods whose points are at one place "
            "are not connected otherwise.",
        .keys = {{.name = "points",
                  .type = ValueType::points,
                  .presence = Presence::required,
                  .sentence = "Two or more, at one place. The node has the name of the first."}},
        .example =
            "[rod.tail]\n"
            "section  = \"tube\"\n"
            "line     = { from = [0, 8, 0], to = [0, 8, -4] }\n"
            "elements = 4\n"
            "element  = \"simo\"\n"
            "\n"
            "[[connect]]\n"
            "points = [\"flyer.end\", \"tail.start\"]\n"};
    return table;
}

const TableSpec& load_table() {
    static const TableSpec table{
        .path = "load",
        .heading = "[[load]]",
        .sentence = "A force and a moment at a point, or along a rod.",
        .keys = load_keys(),
        .groups = {{.rule = GroupRule::exactly_one, .keys = {"at", "on"}},
                   {.rule = GroupRule::at_least_one, .keys = {"force", "moment"}, .only_with = "at"},
                   {.rule = GroupRule::at_least_one,
                    .keys = {"force_per_length", "moment_per_length"},
                    .only_with = "on"}},
        .example =
            "[[load]]\n"
            "at     = \"flyer.start\"\n"
            "force  = [\"pulse(t)/10\", 0, 0]\n"
            "moment = [0, \"-pulse(t)/2\", \"-pulse(t)\"]\n"
            "\n"
            "[[load]]\n"
            "at    = \"flyer@0.25\"\n"
            "force = [0, 0, \"push(t)\"]\n"
            "frame = \"follower\"\n"
            "\n"
            "[[load]]\n"
            "on = \"flyer\"\n"
            "force_per_length = [0, 0, \"-2*push(t)*(1 - s/10)\"]\n"};
    return table;
}

const TableSpec& support_table() {
    static const TableSpec table{
        .path = "support",
        .heading = "[[support]]",
        .sentence =
            "Components of a point that are fixed or move as prescribed. Of the rotations none, all "
            "three or exactly two fixed: a hinge about the third axis. Supports of one point add up.",
        .keys = {{.name = "at",
                  .type = ValueType::point,
                  .presence = Presence::required,
                  .sentence = "A point of a rod, or a body."},
                 {.name = "fix",
                  .type = ValueType::choices,
                  .sentence = "position is x y z, rotation is rx ry rz, all is both.",
                  .choices = fix_words()},
                 {.name = "move",
                  .type = ValueType::table,
                  .sentence =
                      "Prescribed motion. Where a rotation is moved, the other two are fixed or moved "
                      "too, and exp of the vector (rx, ry, rz), of any size, is the rotation since "
                      "t = 0. In a dynamic analysis 0 at t = 0.",
                  .table = &move_table()},
                 {.name = "axes",
                  .type = ValueType::matrix,
                  .dimension = "1",
                  .default_text = "the global axes",
                  .sentence = "The support's own x, y and z directions, a row each: of length 1, at right "
                              "angles, right-handed (to 1e-6). fix and move are along them; they stay."},
                 stages_key("The stages in which the support holds. What it fixes it holds where that is; a "
                            "move begins where the point is.")},
        .groups = {{.rule = GroupRule::at_least_one, .keys = {"fix", "move"}}},
        .example =
            "[[support]]\n"
            "at  = \"gyroscope\"\n"
            "fix = \"position\"\n"
            "\n"
            "[[support]]\n"
            "at   = \"tail.end\"\n"
            "fix  = [\"y\", \"z\"]\n"
            "move = { x = \"0.1*sin(t)\" }\n"
            "axes = [[0, 0, 1], [1, 0, 0], [0, 1, 0]]\n"};
    return table;
}

namespace {

const TableSpec& spin_table() {
    static const TableSpec table{.path = "initial.spin",
                                 .heading = "spin = { … }",
                                 .sentence = "",
                                 .keys = {{.name = "axis",
                                           .type = ValueType::vector,
                                           .dimension = "1",
                                           .presence = Presence::required,
                                           .sentence = "Its direction, of any length."},
                                          {.name = "through",
                                           .type = ValueType::vector,
                                           .dimension = "length",
                                           .default_value = Vec3(0.0, 0.0, 0.0),
                                           .sentence = "A point of the axis."},
                                          {.name = "rate",
                                           .type = ValueType::number,
                                           .dimension = "angle/time",
                                           .presence = Presence::required,
                                           .sentence = "Right-handed about the axis."}}};
    return table;
}

}  // namespace

const TableSpec& initial_table() {
    static const TableSpec table{
        .path = "initial",
        .heading = "[[initial]]",
        .sentence = "The velocities of the nodes of rods and bodies at t = 0. For dynamic analyses.",
        .keys = {{.name = "on",
                  .type = ValueType::names,
                  .presence = Presence::required,
                  .sentence = "The name of a rod or body, or a list of them.",
                  .refers_to = {"rod", "body"}},
                 {.name = "velocity",
                  .type = ValueType::place_vector,
                  .dimension = "length/time",
                  .default_text = "[0, 0, 0]",
                  .sentence = "Global components; x, y, z is the place at t = 0, and s the arc length from a "
                              "rod's start."},
                 {.name = "angular_velocity",
                  .type = ValueType::place_vector,
                  .dimension = "angle/time",
                  .default_text = "[0, 0, 0]",
                  .sentence = "Global components, in the same variables."},
                 {.name = "spin",
                  .type = ValueType::table,
                  .sentence = "Turns all of them as one rigid body about an axis, in addition to velocity.",
                  .table = &spin_table()}},
        .groups = {{.rule = GroupRule::at_least_one, .keys = {"velocity", "angular_velocity", "spin"}},
                   {.rule = GroupRule::at_most_one, .keys = {"angular_velocity", "spin"}}},
        .example =
            "[[initial]]\n"
            "on = \"tail\"\n"
            "angular_velocity = [0, 0, \"2*s\"]\n"};
    return table;
}

}  // namespace gxrod
