#include "deck/schema/choices.hpp"
#include "deck/schema/schema_tables.hpp"

// [joint.NAME] and [gear.NAME].
namespace gxrod {
namespace {

constexpr Range not_negative{.lower = 0.0};

// Which coordinates a table inside that of a joint is about.
enum class Coordinates { any, turn, slide };

// Of a turn, of a slide, of either.
template <Coordinates which>
const char* choose(const char* any, const char* turn, const char* slide) {
    return which == Coordinates::any ? any : which == Coordinates::turn ? turn : slide;
}

// The tables `turn` and `slide` of a table for either.
template <Coordinates which>
void add_parts(TableSpec& table, const TableSpec& turn, const TableSpec& slide) {
    if (which != Coordinates::any) return;
    table.keys.push_back({.name = "turn",
                          .type = ValueType::table,
                          .sentence = "Of the turn of a joint that has a slide, too.",
                          .table = &turn});
    table.keys.push_back({.name = "slide",
                          .type = ValueType::table,
                          .sentence = "Of the slide of a joint that has a turn, too.",
                          .table = &slide});
}

template <Coordinates which>
std::string path_of(const char* key) {
    return std::string("joint.NAME.") + key + choose<which>("", ".turn", ".slide");
}

template <Coordinates which>
std::string heading_of(const char* key) {
    return std::string(choose<which>(key, "turn", "slide")) + " = { … }";
}

KeySpec damping_key(const char* dimension, const char* sentence) {
    return {.name = "damping",
            .type = ValueType::number,
            .dimension = dimension,
            .range = not_negative,
            .default_value = 0.0,
            .sentence = sentence};
}

template <Coordinates which>
const TableSpec& joint_spring_table();

template <Coordinates which>
TableSpec make_joint_spring_table() {
    TableSpec table{
        .path = path_of<which>("spring"),
        .heading = heading_of<which>("spring"),
        .sentence = "",
        .keys = {{.name = "stiffness",
                  .type = ValueType::number,
                  .dimension = choose<which>("moment/angle or force/length", "moment/angle", "force/length"),
                  .range = not_negative,
                  .default_value = 0.0,
                  .sentence = "Moment or force back to `rest`, per angle or length from there."},
                 damping_key(
                     choose<which>(
                         "moment·time/angle or force·time/length", "moment·time/angle", "force·time/length"),
                     "Moment or force per rate of the coordinate."),
                 {.name = "rest",
                  .type = ValueType::time_expression,
                  .dimension = choose<which>("angle or length", "angle", "length"),
                  .default_text = "0: the place at t = 0",
                  .sentence = "Where the spring exerts nothing.",
                  .only_with = "stiffness"}},
        .groups = {{GroupRule::at_least_one, {"stiffness", "damping"}}}};
    if constexpr (which == Coordinates::any) {
        add_parts<which>(
            table, joint_spring_table<Coordinates::turn>(), joint_spring_table<Coordinates::slide>());
        table.groups = {{GroupRule::at_least_one, {"stiffness", "damping", "turn", "slide"}}};
    }
    return table;
}

template <Coordinates which>
const TableSpec& joint_spring_table() {
    static const TableSpec table = make_joint_spring_table<which>();
    return table;
}

KeySpec friction_key(const char* name, const char* dimension, const char* sentence) {
    return {.name = name,
            .type = ValueType::number,
            .dimension = dimension,
            .range = not_negative,
            .sentence = sentence};
}

template <Coordinates which>
const TableSpec& friction_table();

template <Coordinates which>
TableSpec make_friction_table() {
    TableSpec table{.path = path_of<which>("friction"),
                    .heading = heading_of<which>("friction"),
                    .sentence = "",
                    .keys = {}};
    std::vector<std::string> sizes;
    if (which != Coordinates::slide) {
        table.keys.push_back(friction_key("moment", "moment", "Moment that resists a turn."));
        sizes.emplace_back("moment");
    }
    if (which != Coordinates::turn) {
        table.keys.push_back(friction_key("force", "force", "Force that resists a slide."));
        sizes.emplace_back("force");
    }
    table.keys.push_back(friction_key(
        "coefficient",
        "1",
        choose<which>(
            "Friction by the force that the joint holds: of a turn coefficient × radius × force, of a "
            "slide coefficient × force.",
            "The moment is coefficient × radius × the force that the joint holds.",
            "The force is coefficient × the force that the joint holds.")));
    sizes.emplace_back("coefficient");
    if (which != Coordinates::slide) {
        table.keys.push_back({.name = "radius",
                              .type = ValueType::number,
                              .dimension = "length",
                              .range = positive,
                              .sentence = "Of the pin of a turn. Required with coefficient.",
                              .only_with = "coefficient"});
    }
    table.keys.push_back(
        {.name = "stick",
         .type = ValueType::number,
         .dimension = choose<which>("angle or length", "angle", "length"),
         .range = positive,
         .default_text = choose<which>(
             "1e-4 of a turn, 1e-5 of the model's size of a slide", "1e-4", "1e-5 of the model's size"),
         .sentence = "How far the joint gives way, like a spring, before it slips."});
    if constexpr (which == Coordinates::any) {
        table.groups.push_back({GroupRule::at_most_one, sizes});
        add_parts<which>(table, friction_table<Coordinates::turn>(), friction_table<Coordinates::slide>());
        sizes.insert(sizes.end(), {"turn", "slide"});
    }
    table.groups.push_back({GroupRule::at_least_one, sizes});
    return table;
}

template <Coordinates which>
const TableSpec& friction_table() {
    static const TableSpec table = make_friction_table<which>();
    return table;
}

template <Coordinates which>
const TableSpec& limits_table();

template <Coordinates which>
TableSpec make_limits_table() {
    const char* dimension = choose<which>("angle or length", "angle", "length");
    TableSpec table{
        .path = path_of<which>("limits"),
        .heading = heading_of<which>("limits"),
        .sentence = "",
        .keys = {{.name = "lower",
                  .type = ValueType::number,
                  .dimension = dimension,
                  .default_text = "none",
                  .sentence = "Below it a spring pushes the coordinate up."},
                 {.name = "upper",
                  .type = ValueType::number,
                  .dimension = dimension,
                  .default_text = "none",
                  .sentence = "Above it a spring pushes the coordinate down."},
                 {.name = "stiffness",
                  .type = ValueType::number,
                  .dimension = choose<which>("moment/angle or force/length", "moment/angle", "force/length"),
                  .range = positive,
                  .sentence = "Of that spring. Required with a bound."},
                 damping_key(
                     choose<which>(
                         "moment·time/angle or force·time/length", "moment·time/angle", "force·time/length"),
                     "Of a damper that acts with it.")},
        .groups = {{GroupRule::at_least_one, {"lower", "upper"}}}};
    if constexpr (which == Coordinates::any) {
        add_parts<which>(table, limits_table<Coordinates::turn>(), limits_table<Coordinates::slide>());
        table.groups = {{GroupRule::at_least_one, {"lower", "upper", "turn", "slide"}}};
    }
    return table;
}

template <Coordinates which>
const TableSpec& limits_table() {
    static const TableSpec table = make_limits_table<which>();
    return table;
}

// Of types whose free coordinates motors and springs can act on.
std::vector<Condition> with_coordinates() {
    return {{"type", {"hinge", "cylinder", "slider", "universal", "screw", "plane", "free", "sleeve"}}};
}

std::vector<Condition> with_axis() {
    return {{"type", {"hinge", "cylinder", "slider", "universal", "screw", "plane", "free"}}};
}

std::vector<Condition> only_distance() { return {{"type", {"distance"}}}; }

std::vector<KeySpec> place_keys() {
    return {
        {.name = "type",
         .type = ValueType::choice,
         .presence = Presence::required,
         .sentence = "What it leaves free. ball: all turns. hinge: the turn about its axis. cylinder: turn "
                     "and slide. slider: the slide along its axis. universal: turns about `axis`, fixed in "
                     "A, and `axis_b`, fixed in B. screw: a turn, with a slide of `lead` a turn. plane: "
                     "slides across its axis and the turn about it. weld: nothing. distance: all but the "
                     "distance of two points. free: everything; for what acts on the turn and the slide. "
                     "sleeve: a point's slide along a rod, and all turns.",
         .choices = words_of(joint_kind_choices)},
        {.name = "between",
         .type = ValueType::ends,
         .presence = Presence::required,
         .sentence = "A and B: points of rods, bodies, or \"ground\" for what does not move. A point can "
                     "be in several joints. Of a sleeve, A is a rod."},
        {.name = "at",
         .type = ValueType::vector,
         .dimension = "length",
         .default_text = "where A and B are, at one place; else the point of the only rod",
         .sentence = "Where the joint is at t = 0, global. Rigid arms join it to the nodes of A and B.",
         .only_for = {{"type",
                       {"ball",
                        "hinge",
                        "cylinder",
                        "slider",
                        "universal",
                        "screw",
                        "plane",
                        "weld",
                        "free",
                        "sleeve"}}}},
        {.name = "at_a",
         .type = ValueType::vector,
         .dimension = "length",
         .default_text = "where its node is; of the ground required",
         .sentence = "Where A's point is at t = 0, global.",
         .only_for = only_distance()},
        {.name = "at_b",
         .type = ValueType::vector,
         .dimension = "length",
         .default_text = "where its node is; of the ground required",
         .sentence = "Where B's point is at t = 0, global.",
         .only_for = only_distance()}};
}

std::vector<KeySpec> axis_keys() {
    return {{.name = "axis",
             .type = ValueType::vector,
             .dimension = "1",
             .presence = Presence::required,
             .sentence = "Its axis, of a plane the normal: global at t = 0, of any length; A and B carry it.",
             .remark = "the direction of its axis at t = 0, global",
             .only_for = with_axis()},
            {.name = "axis_b",
             .type = ValueType::vector,
             .dimension = "1",
             .presence = Presence::required,
             .sentence = "Of a universal joint: the axis fixed in B, at right angles to `axis`.",
             .remark = "the axis that B carries",
             .only_for = {{"type", {"universal"}}}},
            {.name = "lead",
             .type = ValueType::number,
             .dimension = "length",
             .presence = Presence::required,
             .sentence = "Of a screw: the slide along the axis in one turn; negative if left-handed.",
             .remark = "the slide in one turn",
             .only_for = {{"type", {"screw"}}}},
            {.name = "length",
             .type = ValueType::number,
             .dimension = "length",
             .range = positive,
             .default_text = "as it is at t = 0",
             .sentence = "Of a distance: that of the points, for a check of where they are.",
             .only_for = only_distance()}};
}

std::vector<KeySpec> coordinate_keys() {
    return {
        {.name = "move",
         .type = ValueType::coordinate_functions,
         .dimension = "angle or length",
         .default_text = "free",
         .sentence = "A motor: the coordinate since t = 0. It is 0 at t = 0 in a dynamic analysis. A turn "
                     "is the right-hand one of B against A, a slide that of B along the axis.",
         .only_for = with_coordinates()},
        {.name = "drive",
         .type = ValueType::coordinate_functions,
         .dimension = "moment or force",
         .default_text = "0",
         .sentence = "Moment, or force, that A exerts on B along the axis.",
         .only_for = with_coordinates()},
        {.name = "spring",
         .type = ValueType::table,
         .sentence = "A spring and a damper on the coordinate, for any number of turns.",
         .only_for = with_coordinates(),
         .table = &joint_spring_table<Coordinates::any>()},
        {.name = "friction",
         .type = ValueType::table,
         .sentence = "Dry friction of the coordinate.",
         .only_for = with_coordinates(),
         .table = &friction_table<Coordinates::any>()},
        {.name = "limits",
         .type = ValueType::table,
         .sentence = "Springs at the ends of a coordinate's range.",
         .only_for = with_coordinates(),
         .table = &limits_table<Coordinates::any>()}};
}

std::vector<KeySpec> joint_keys() {
    std::vector<KeySpec> keys = place_keys();
    for (auto* more : {&axis_keys, &coordinate_keys}) {
        for (KeySpec& key : more()) keys.push_back(std::move(key));
    }
    return keys;
}

}  // namespace

const TableSpec& joint_table() {
    static const TableSpec table{
        .path = "joint.NAME",
        .heading = "[joint.NAME]",
        .sentence =
            "What two points, A and B, of rods, bodies or the ground can still do against each other. Angles "
            "and lengths of its coordinates are 0 at t = 0, forces and moments are those that A exerts on B.",
        .keys = joint_keys(),
        .example =
            "[joint.pivot]\n"
            "type    = \"hinge\"\n"
            "between = [\"tail.end\", \"gyroscope\"]\n"
            "axis    = [0, 1, 0]\n"
            "spring  = { stiffness = 2.0, damping = 0.01 }\n"};
    return table;
}

}  // namespace gxrod
