#include "deck/schema/choices.hpp"
#include "deck/schema/schema_tables.hpp"

// [tendon.NAME], [[actuation]] and [[magnetic]]: what acts from inside.
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

namespace {

constexpr const char* force_dimension = "mass·length/time²";

KeySpec on_key() {
    return {.name = "on",
            .type = ValueType::reference,
            .presence = Presence::required,
            .sentence = "The name of a rod.",
            .refers_to = {"rod"}};
}

KeySpec fraction_key(const char* name, double value, const char* sentence) {
    return {.name = name,
            .type = ValueType::number,
            .dimension = "1",
            .range = {.lower = 0.0, .upper = 1.0},
            .default_value = value,
            .sentence = sentence};
}

KeySpec line_key(const char* name, ValueType type, const char* dimension, const char* sentence) {
    return {.name = name, .type = type, .dimension = dimension, .default_text = "0", .sentence = sentence};
}

}  // namespace

const TableSpec& tendon_table() {
    static const TableSpec table{
        .path = "tendon.NAME",
        .heading = "[tendon.NAME]",
        .sentence =
            "A tendon that slides along a path within a rod, fixed to it at both ends. "
            "[Tendons and muscles](guide/tendons.md) explains it.",
        .keys = {on_key(),
                 {.name = "offset",
                  .type = ValueType::tendon_path,
                  .dimension = "length",
                  .presence = Presence::required,
                  .sentence =
                      "Where it passes through the section: y and z, from the line of the rod. Functions of "
                      "s, the arc length from the rod's start; or at fractions of the rod's length, straight "
                      "between them, with a node at each."},
                 {.name = "tension",
                  .type = ValueType::time_expression,
                  .dimension = force_dimension,
                  .sentence =
                      "The same all along; with friction where it is pulled. Below 0 it pushes: −p A of a "
                      "chamber of the area A across, under the pressure p."},
                 {.name = "shortening",
                  .type = ValueType::time_expression,
                  .dimension = "length",
                  .sentence = "What a winch draws in: by how much the tendon's part within the rod is "
                              "shorter than at t = 0. The tension follows."},
                 {.name = "length",
                  .type = ValueType::time_expression,
                  .dimension = "length",
                  .sentence =
                      "The same by the length of that part. A value without t is reached from that at "
                      "t = 0 in the first static stage."},
                 {.name = "stiffness",
                  .type = ValueType::number,
                  .dimension = force_dimension,
                  .range = {.lower = 0.0, .at_lower = Bound::open},
                  .default_text = "does not stretch",
                  .sentence = "EA of a tendon with a winch, or of one that sticks by friction: a force over "
                              "the strain that it causes."},
                 {.name = "friction",
                  .type = ValueType::number,
                  .dimension = "1",
                  .range = {.lower = 0.0},
                  .default_value = 0.0,
                  .sentence = "Coefficient μ of a tendon whose tension is given: where the tendon turns by "
                              "dφ its tension changes by μ T dφ as it slips."},
                 {.name = "pulled_at",
                  .type = ValueType::choice,
                  .default_value = "from",
                  .sentence = "With friction, the end that has the tension; the other one is anchored.",
                  .choices = words_of(tendon_end_choices)},
                 {.name = "slack",
                  .type = ValueType::flag,
                  .default_text = "true",
                  .sentence = "Whether a tendon with a winch hangs loose where it is too long; otherwise it "
                              "pushes there."},
                 fraction_key("from",
                              0.0,
                              "Where it starts, as a fraction of the rod's length, where a node is placed."),
                 fraction_key("to", 1.0, "Where it ends, likewise."),
                 factor_key("tension or shortening"),
                 stages_key("The stages in which it pulls; in others it hangs loose.")},
        .groups = {{GroupRule::exactly_one, {"tension", "shortening", "length"}}},
        .example =
            "[tendon.pull]\n"
            "on      = \"flyer\"\n"
            "offset  = [\"0.1*cos(s)\", \"0.1*sin(s)\"]\n"
            "tension = \"5*pulse(t)\"\n"
            "to      = 0.75\n"};
    return table;
}

const TableSpec& actuation_table() {
    constexpr const char* per_length = "1/length";
    static const TableSpec table{
        .path = "actuation",
        .heading = "[[actuation]]",
        .sentence =
            "Strains that the sections of a rod would take by themselves: those of muscles, growth and heat. "
            "They add to the stress-free shape. In section axes; s is the arc length from the rod's start.",
        .keys = {on_key(),
                 line_key("stretch", ValueType::line_expression, "1", "Along the rod."),
                 line_key("shear", ValueType::line_pair, "1", "Along y and z."),
                 line_key("curvature", ValueType::line_vector, per_length, "About x (twist), y and z."),
                 line_key("temperature",
                          ValueType::line_expression,
                          "temperature",
                          "Above that of the stress-free shape. It acts by the section's expansion."),
                 line_key("temperature_gradient",
                          ValueType::line_pair,
                          "temperature/length",
                          "How fast the temperature rises along y and z."),
                 factor_key("value"),
                 stages_key("The stages in which it acts.")},
        .groups = {{GroupRule::at_least_one,
                    {"stretch", "shear", "curvature", "temperature", "temperature_gradient"}}},
        .example =
            "[[actuation]]\n"
            "on        = \"tail\"\n"
            "curvature = [0, 0, \"0.1*s*sin(t)\"]\n"};
    return table;
}

const TableSpec& magnetic_table() {
    static const TableSpec table{
        .path = "magnetic",
        .heading = "[[magnetic]]",
        .sentence =
            "A rod that is magnetic along its length, in a field: couples μ × B and, where the field changes "
            "with the place, forces (∇B)ᵀ μ.",
        .keys = {on_key(),
                 {.name = "moment",
                  .type = ValueType::line_vector,
                  .dimension = "current·length",
                  .presence = Presence::required,
                  .sentence =
                      "Magnetic moment μ per reference length, in section axes; s is the arc length from the "
                      "rod's start."},
                 {.name = "field",
                  .type = ValueType::field_vector,
                  .dimension = "mass/(current·time²)",
                  .presence = Presence::required,
                  .sentence = "Flux density B, global components; x, y, z is where the section is then."},
                 factor_key("field"),
                 stages_key("The stages in which the field acts.")},
        .example =
            "[[magnetic]]\n"
            "on     = \"tail\"\n"
            "moment = [0.5, 0, 0]\n"
            "field  = [0, \"0.01*sin(10*t)\", \"0.02*z\"]\n"};
    return table;
}

}  // namespace gxrod
