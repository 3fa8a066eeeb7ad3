#include "deck/schema/choices.hpp"
#include "deck/schema/schema_tables.hpp"

// [[connect]] and [[initial]].
namespace gxrod {
KeySpec stages_key(const char* sentence) {
    return {.name = "stages",
            .type = ValueType::names,
            .default_text = "all",
            .sentence = sentence,
            .refers_to = {"stage"}};
}

std::string factor_sentence(const std::string& what) {
    return "What the " + what +
           " is multiplied by, in a stage's own t. By stage: a stage that is not named keeps the last "
           "value, and before the first one there is no " +
           what + ".";
}

KeySpec factor_key(const std::string& what) {
    return {.name = "factor",
            .type = ValueType::stage_functions,
            .dimension = "1",
            .default_text = factor_default,
            .sentence = factor_sentence(what)};
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
