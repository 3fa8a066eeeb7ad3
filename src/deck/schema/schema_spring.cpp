#include <map>

#include "deck/schema/choices.hpp"
#include "deck/schema/schema_tables.hpp"
#include "model/model.hpp"

namespace gxrod {

const TableSpec& spring_table() {
    constexpr Range not_negative{.lower = 0.0};
    static const TableSpec table{
        .path = "spring.NAME",
        .heading = "[spring.NAME]",
        .sentence =
            "A spring and a damper along the line between two points, A and B. Their force is stiffness "
            "times (length now - length) plus damping times the rate of the length plus force, tension "
            "positive.",
        .keys = {{.name = "between",
                  .type = ValueType::ends,
                  .presence = Presence::required,
                  .sentence = "What carries A and B: points of rods, bodies, or \"ground\" for one that does "
                              "not move."},
                 {.name = "at_a",
                  .type = ValueType::vector,
                  .dimension = "length",
                  .default_text = "where its node is; of the ground required",
                  .sentence = "Where A is at t = 0, global. A rigid arm joins it to its node."},
                 {.name = "at_b",
                  .type = ValueType::vector,
                  .dimension = "length",
                  .default_text = "where its node is; of the ground required",
                  .sentence = "Where B is at t = 0, likewise."},
                 {.name = "stiffness",
                  .type = ValueType::number,
                  .dimension = "force/length",
                  .range = not_negative,
                  .default_value = 0.0,
                  .sentence = "Force per elongation."},
                 {.name = "damping",
                  .type = ValueType::number,
                  .dimension = "force·time/length",
                  .range = not_negative,
                  .default_value = 0.0,
                  .sentence = "Force per rate of elongation."},
                 {.name = "force",
                  .type = ValueType::spring_expression,
                  .dimension = "force",
                  .default_text = "0",
                  .sentence =
                      "A force in addition, tension positive; length is the distance of A and B then, "
                      "rate how fast that grows. A table is a [function.NAME] of the length."},
                 {.name = "length",
                  .type = ValueType::number,
                  .dimension = "length",
                  .range = not_negative,
                  .default_text = "as it is at t = 0",
                  .sentence = "At which stiffness pulls and pushes nothing; 0 for one that always pulls."}},
        .groups = {{GroupRule::at_least_one, {"stiffness", "damping", "force"}}},
        .example =
            "[spring.strut]\n"
            "between   = [\"flyer.start\", \"gyroscope\"]\n"
            "at_b      = [0, 0, 1]\n"
            "stiffness = 500.0\n"
            "damping   = 2.0\n"
            "length    = 0.3\n"
            "\n"
            "[spring.stop]\n"
            "between = [\"ground\", \"gyroscope\"]\n"
            "at_a    = [0, 0, -2]\n"
            "force   = \"length < 0.5 ? 1e4*(length - 0.5) + 20*rate : 0\"\n"};
    return table;
}

namespace {

// What a bushing resists, component by component.
const TableSpec& components_table(const char* key, const char* along, const char* about) {
    static std::map<std::string, TableSpec> tables;
    TableSpec& table = tables[key];
    if (!table.keys.empty()) return table;
    table.path = std::string("bushing.NAME.") + key;
    table.heading = std::string(key) + " = { … }";
    for (std::size_t i = 0; i < component_names.size(); ++i) {
        const std::string axis(component_names[i].substr(component_names[i].size() - 1));
        table.keys.push_back({.name = std::string(component_names[i]),
                              .type = ValueType::number,
                              .dimension = i < 3 ? along : about,
                              .range = {.lower = 0.0},
                              .default_value = 0.0,
                              .sentence = (i < 3 ? "Along " : "About ") + axis + "."});
    }
    return table;
}

KeySpec components_key(const char* name, const TableSpec& table, const char* sentence) {
    return {.name = name, .type = ValueType::table, .sentence = sentence, .table = &table};
}

KeySpec matrix_key(const char* name, const char* sentence) {
    return {.name = name, .type = ValueType::section_matrix, .dimension = "of both", .sentence = sentence};
}

}  // namespace

const TableSpec& bushing_table() {
    static const TableSpec table{
        .path = "bushing.NAME",
        .heading = "[bushing.NAME]",
        .sentence =
            "Resists displacements and rotations of B against A in all directions: with stiffness about "
            "axes only, a torsion spring. It is free of force as it is at t = 0.",
        .keys = {{.name = "between",
                  .type = ValueType::ends,
                  .presence = Presence::required,
                  .sentence = "What A and B are fixed to: points of rods, bodies, or \"ground\"."},
                 {.name = "at",
                  .type = ValueType::vector,
                  .dimension = "length",
                  .default_text = "where the nodes are, which must be at one place",
                  .sentence = "Where it is at t = 0, global. Rigid arms join it to the nodes."},
                 {.name = "axes",
                  .type = ValueType::axes,
                  .dimension = "1",
                  .default_text = "the global axes, `between`",
                  .sentence =
                      "Its x, y and z directions at t = 0, a row each: of length 1, at right angles, "
                      "right-handed (to 1e-6). They turn with A and B, half way between. Or what they "
                      "turn with: A, B, nothing (`ground`) or both. A bearing's axes do not turn with "
                      "the shaft: take the word of what carries the bearing. Then a rotation that is "
                      "free of stiffness can be of any size.",
                  .choices = words_of(bushing_axes_choices)},
                 {.name = "directions",
                  .type = ValueType::matrix,
                  .dimension = "1",
                  .default_text = "the global axes",
                  .sentence = "Its x, y and z directions at t = 0, likewise, where `axes` is a word.",
                  .only_with = "axes"},
                 components_key("stiffness",
                                components_table("stiffness", "force/length", "force·length/angle"),
                                "Force per displacement and moment per rotation."),
                 matrix_key(
                     "stiffness_matrix",
                     "The same as a full matrix, order x y z rx ry rz: symmetric, no energy negative."),
                 components_key("damping",
                                components_table("damping", "force·time/length", "force·length·time/angle"),
                                "Force and moment per rate."),
                 matrix_key("damping_matrix", "The same as a full matrix, likewise.")},
        .groups = {{GroupRule::at_least_one, {"stiffness", "stiffness_matrix", "damping", "damping_matrix"}},
                   {GroupRule::at_most_one, {"stiffness", "stiffness_matrix"}},
                   {GroupRule::at_most_one, {"damping", "damping_matrix"}}},
        .example =
            "[bushing.mount]\n"
            "between   = [\"ground\", \"gyroscope\"]\n"
            "at        = [0, 0, 0]\n"
            "stiffness = { x = 1e3, y = 1e3, z = 4e3, rx = 20, ry = 20 }\n"
            "damping   = { z = 30 }\n"
            "\n"
            "[bushing.bearing]\n"
            "between   = [\"ground\", \"gyroscope\"]\n"
            "at        = [0, 0, 0]\n"
            "axes      = \"ground\"\n"
            "stiffness = { x = 1e4, y = 1e4, z = 1e4, rx = 50, ry = 50 }\n"};
    return table;
}

}  // namespace gxrod
