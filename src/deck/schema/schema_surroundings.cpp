#include "deck/schema/choices.hpp"
#include "deck/schema/schema_tables.hpp"

// What water and air see of sections.
namespace gxrod {
namespace {

constexpr Range not_negative{.lower = 0.0};
constexpr const char* density_dimension = "mass/length³";
constexpr const char* pressure_dimension = "mass/(length·time²)";

KeySpec number_key(const char* name, const char* dimension, Range range, const char* sentence) {
    return {.name = name,
            .type = ValueType::number,
            .dimension = dimension,
            .range = range,
            .sentence = sentence};
}

KeySpec required(KeySpec key) {
    key.presence = Presence::required;
    return key;
}

KeySpec defaulted(KeySpec key, double value) {
    key.default_value = value;
    return key;
}

KeySpec described(KeySpec key, const char* default_text) {
    key.default_text = default_text;
    return key;
}

KeySpec arc_key(const char* name, const char* dimension, Range range, const char* sentence) {
    KeySpec key = number_key(name, dimension, range, sentence);
    key.type = ValueType::arc_number;
    return key;
}

KeySpec table_key(const char* name, const TableSpec& table, const char* sentence) {
    return {.name = name, .type = ValueType::table, .sentence = sentence, .table = &table};
}

KeySpec number_or_table(const char* name,
                        const TableSpec& table,
                        const char* default_text,
                        const char* text) {
    return {.name = name,
            .type = ValueType::number_or_table,
            .dimension = "1",
            .range = not_negative,
            .default_text = default_text,
            .sentence = text,
            .table = &table};
}

KeySpec coefficient_key(const char* name, const char* default_text, const char* sentence) {
    return described(arc_key(name, "1", not_negative, sentence), default_text);
}

std::vector<KeyGroup> coefficient_groups() {
    return {{GroupRule::at_most_one, {"normal", "y"}},
            {GroupRule::at_most_one, {"normal", "z"}},
            {GroupRule::at_most_one, {"tangential", "x"}}};
}

const TableSpec& drag_table() {
    static const TableSpec table{
        .path = "section.NAME.fluid.drag",
        .heading = "drag = { … }",
        .sentence = "",
        .keys = {coefficient_key("normal", "1.2", "Across the rod, of the width outer_diameter."),
                 coefficient_key("tangential", "0", "Along it, of the surface pi × outer_diameter."),
                 coefficient_key("x", "0", "In place of tangential."),
                 coefficient_key("y", "1.2", "Along the section's y, in place of normal."),
                 coefficient_key("z", "1.2", "Along z, in place of normal.")},
        .groups = coefficient_groups()};
    return table;
}

const TableSpec& added_mass_table() {
    static const TableSpec table{
        .path = "section.NAME.fluid.added_mass",
        .heading = "added_mass = { … }",
        .sentence = "",
        .keys = {coefficient_key("normal", "1", "Across the rod, of the displaced mass."),
                 coefficient_key("tangential", "0", "Along it."),
                 coefficient_key("x", "0", "In place of tangential."),
                 coefficient_key("y", "1", "Along the section's y, in place of normal."),
                 coefficient_key("z", "1", "Along z, in place of normal.")},
        .groups = coefficient_groups()};
    return table;
}

const TableSpec& contents_table() {
    static const TableSpec table{
        .path = "section.NAME.fluid.contents",
        .heading = "contents = { … }",
        .sentence = "",
        .keys = {required(arc_key("density", density_dimension, positive, "Its mass moves with the rod.")),
                 defaulted(number_key("pressure",
                                      pressure_dimension,
                                      {},
                                      "At the surface of the water, or at z = 0; below, its own weight adds "
                                      "to it."),
                           0.0),
                 described(arc_key("inner_diameter", "length", positive, "Of what it fills."),
                           "of a tube, twice inner_radius; else required")}};
    return table;
}

}  // namespace

const TableSpec& section_fluid_table() {
    static const TableSpec table{
        .path = "section.NAME.fluid",
        .heading = "fluid = { … }",
        .sentence = "",
        .keys = {
            described(
                arc_key("outer_diameter", "length", positive, "Of drag, and of what touches the ground."),
                "of a circle or tube, that of the shape; else required"),
            described(arc_key("area", "length²", not_negative, "That displaces water."),
                      "what the shape fills; pi/4 outer_diameter² with that or without a shape"),
            number_or_table("drag",
                            drag_table(),
                            "1.2 across, 0 along the rod",
                            "Coefficients of drag: ½ ρ × width × C × speed². A number is that across "
                            "the rod."),
            number_or_table("added_mass",
                            added_mass_table(),
                            "1 across, 0 along the rod",
                            "Coefficients of added mass, over ρ × area. A number is that across the "
                            "rod."),
            table_key("contents", contents_table(), "What fills the rod; nothing if left out."),
            defaulted(arc_key("poisson",
                              "1",
                              {.lower = 0.0, .upper = 0.5},
                              "Poisson's ratio of the wall: by how much pressures stretch the rod, "
                              "(1 − 2 poisson)(p_i A_i − p_o A_o)/EA. At ½ they do not."),
                      0.5)}};
    return table;
}

}  // namespace gxrod
