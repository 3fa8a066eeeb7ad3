#include <fmt/format.h>

#include "deck/choices.hpp"
#include "deck/schema_tables.hpp"
#include "state/motion.hpp"

// [function.NAME], [section.NAME], [rod.NAME] and [body.NAME].
namespace gxrod {
namespace {

constexpr const char* axial_stiffness = "mass·length/time²";
constexpr const char* bending_stiffness = "mass·length³/time²";
constexpr const char* no_inertia = "a rotation without inertia cannot be integrated in time";

// A lower bound: motions of a node at two time levels, a row of the block-tridiagonal tangent and of its
// factors.
std::string describe_memory_of_largest_rod() {
    constexpr double bytes_per_entry = sizeof(double) + sizeof(int);
    constexpr double entries = 3 * 6 * 6;
    constexpr double bytes = 2.0 * sizeof(NodeMotion) + 2.0 * entries * bytes_per_entry;
    return fmt::format("{} elements already need more than {:.0f} GB of memory",
                       largest_element_count,
                       bytes * static_cast<double>(largest_element_count) / 1e9);
}

KeySpec stiffness_key(const char* name, const char* dimension, const char* sentence) {
    return {.name = name,
            .type = ValueType::number,
            .dimension = dimension,
            .range = positive,
            .presence = Presence::required,
            .sentence = sentence};
}

const TableSpec& stiffness_table() {
    static const TableSpec table{
        .path = "section.NAME.stiffness",
        .heading = "stiffness = { … }",
        .sentence = "",
        .keys = {stiffness_key("EA", axial_stiffness, "Axial stiffness."),
                 stiffness_key("GAy", axial_stiffness, "Shear stiffness along y."),
                 stiffness_key("GAz", axial_stiffness, "Shear stiffness along z."),
                 stiffness_key("GJ", bending_stiffness, "Torsional stiffness."),
                 stiffness_key("EIy", bending_stiffness, "Bending stiffness about y."),
                 stiffness_key("EIz", bending_stiffness, "Bending stiffness about z.")}};
    return table;
}

KeySpec rotary_key(const char* name, Presence presence, const char* default_text, const char* sentence) {
    return {.name = name,
            .type = ValueType::number,
            .dimension = "mass·length",
            .range = positive,
            .presence = presence,
            .default_text = default_text,
            .sentence = sentence,
            .remark = no_inertia};
}

const TableSpec& inertia_table() {
    static const TableSpec table{
        .path = "section.NAME.inertia",
        .heading = "inertia = { … }",
        .sentence = "",
        .keys = {
            {.name = "rhoA",
             .type = ValueType::number,
             .dimension = "mass/length",
             .range = positive,
             .presence = Presence::required,
             .sentence = "Mass per length."},
            rotary_key("rhoJ", Presence::optional, "rhoIy + rhoIz", "Rotary inertia per length about x."),
            rotary_key("rhoIy", Presence::required, "", "Rotary inertia per length about y."),
            rotary_key("rhoIz", Presence::required, "", "Rotary inertia per length about z.")}};
    return table;
}

const TableSpec& line_table() {
    static const TableSpec table{.path = "rod.NAME.line",
                                 .heading = "line = { … }",
                                 .sentence = "",
                                 .keys = {{.name = "from",
                                           .type = ValueType::vector,
                                           .dimension = "length",
                                           .presence = Presence::required,
                                           .sentence = "Where the rod starts."},
                                          {.name = "to",
                                           .type = ValueType::vector,
                                           .dimension = "length",
                                           .presence = Presence::required,
                                           .sentence = "Where it ends."}}};
    return table;
}

}  // namespace

const TableSpec& function_table() {
    static const TableSpec table{
        .path = "function.NAME",
        .heading = "[function.NAME]",
        .sentence = "A function of one variable that values given as f(t) can call, as in \"0.5*pulse(t)\".",
        .keys = {{.name = "table",
                  .type = ValueType::time_table,
                  .sentence =
                      "Rows [t, value] with t increasing: linear between rows, the first and the last value "
                      "held outside."},
                 {.name = "expression",
                  .type = ValueType::time_expression,
                  .sentence = "The value in terms of t; may call other functions."}},
        .groups = {{GroupRule::exactly_one, {"table", "expression"}}},
        .example =
            "[function.pulse]\n"
            "table = [[0, 0], [2.5, 200], [5, 0]]\n"
            "\n"
            "[function.push]\n"
            "expression = \"t < 2.5 ? 8*sin(pi*t/2.5)^2 : 0\"\n"};
    return table;
}

const TableSpec& section_table() {
    static const TableSpec table{
        .path = "section.NAME",
        .heading = "[section.NAME]",
        .sentence =
            "Constants of a cross-section in its own axes: x along the tangent of the rod, y and z across.",
        .keys = {{.name = "stiffness",
                  .type = ValueType::table,
                  .presence = Presence::required,
                  .sentence = "Resultants from strains.",
                  .table = &stiffness_table()},
                 {.name = "inertia",
                  .type = ValueType::table,
                  .presence = Presence::required,
                  .sentence = "Momenta per length from velocities.",
                  .table = &inertia_table()}},
        .example =
            "[section.tube]\n"
            "stiffness = { EA = 1e4, GAy = 1e4, GAz = 1e4, GJ = \"GJ\", EIy = \"EI\", EIz = \"EI\" }\n"
            "inertia   = { rhoA = 1.0, rhoJ = 20.0, rhoIy = 10.0, rhoIz = 10.0 }\n"};
    return table;
}

const TableSpec& rod_table() {
    static const TableSpec table{
        .path = "rod.NAME",
        .heading = "[rod.NAME]",
        .sentence =
            "A rod of one section, straight at the start. Its points are NAME.start, NAME.end and "
            "NAME@FRACTION, a fraction of the length from 0 to 1, where a node is placed.",
        .keys = {{.name = "section",
                  .type = ValueType::reference,
                  .presence = Presence::required,
                  .sentence = "The name of a [section.NAME].",
                  .refers_to = {"section"}},
                 {.name = "line",
                  .type = ValueType::table,
                  .presence = Presence::required,
                  .sentence = "The centreline at the start.",
                  .table = &line_table()},
                 {.name = "elements",
                  .type = ValueType::integer,
                  .range = {.lower = 1, .upper = static_cast<double>(largest_element_count)},
                  .presence = Presence::required,
                  .sentence =
                      "How many, of equal length; between points NAME@FRACTION in proportion to length.",
                  .above_range = describe_memory_of_largest_rod()},
                 {.name = "order",
                  .type = ValueType::integer,
                  .range = {.lower = 1, .upper = 1},
                  .default_value = static_cast<long>(Rod{}.order),
                  .sentence = "Nodes per element − 1.",
                  .remark = "this version has elements of order 1 only"},
                 {.name = "element",
                  .type = ValueType::choice,
                  .presence = Presence::required,
                  .sentence = "simo: incremental rotation vectors interpolated (Simo and Vu-Quoc 1986).",
                  .choices = words_of(element_kind_choices),
                  .remark = "this version has elements of kind \"simo\" only, and no default"},
                 {.name = "y_axis",
                  .type = ValueType::vector,
                  .dimension = "1",
                  .default_text = "the global axis least aligned with the rod",
                  .sentence = "Section y at the start, projected perpendicular to the rod."}},
        .example =
            "[rod.flyer]\n"
            "section  = \"tube\"\n"
            "line     = { from = [6, 0, 0], to = [0, 8, 0] }\n"
            "elements = 10\n"
            "element  = \"simo\"\n"
            "y_axis   = [0, 0, 1]\n"};
    return table;
}

const TableSpec& body_table() {
    static const TableSpec table{
        .path = "body.NAME",
        .heading = "[body.NAME]",
        .sentence =
            "A rigid body fixed to a node. Its axes at t = 0 are the global axes turned by "
            "rotation_vector. `at`, velocities and loads refer to the node, not to the centre of mass.",
        .keys = {{.name = "mass",
                  .type = ValueType::number,
                  .dimension = "mass",
                  .range = positive,
                  .default_text = "0 if static, else required",
                  .sentence = "Mass."},
                 {.name = "inertia",
                  .type = ValueType::inertia,
                  .dimension = "mass·length²",
                  .default_text = "0 if static or at a rod's point, else required",
                  .sentence =
                      "About the centre of mass, body axes: 3 principal moments or a symmetric 3×3 matrix; "
                      "no principal moment above the sum of the others. Where the body has a node of its own "
                      "in a dynamic analysis, positive definite."},
                 {.name = "at",
                  .type = ValueType::placement,
                  .dimension = "length",
                  .default_value = Vec3(0, 0, 0),
                  .sentence = "Where its node is; or a rod's point, whose node it then shares."},
                 {.name = "centre_of_mass",
                  .type = ValueType::vector,
                  .dimension = "length",
                  .default_value = Vec3(0, 0, 0),
                  .sentence = "From the node, body axes."},
                 {.name = "rotation_vector",
                  .type = ValueType::vector,
                  .dimension = "angle",
                  .default_value = Vec3(0, 0, 0),
                  .sentence = "The attitude at t = 0."},
                 {.name = "velocity",
                  .type = ValueType::vector,
                  .dimension = "length/time",
                  .default_value = Vec3(0, 0, 0),
                  .sentence = "Of the node at t = 0, global components."},
                 {.name = "angular_velocity",
                  .type = ValueType::vector,
                  .dimension = "angle/time",
                  .default_value = Vec3(0, 0, 0),
                  .sentence = "At t = 0, global components."},
                 {.name = "angular_velocity_material",
                  .type = ValueType::vector,
                  .dimension = "angle/time",
                  .default_text = "what angular_velocity says",
                  .sentence = "At t = 0, components in the body axes."}},
        .groups = {{GroupRule::at_most_one, {"angular_velocity", "angular_velocity_material"}}},
        .example =
            "[body.gyroscope]\n"
            "mass            = 1.0\n"
            "inertia         = [1.0, 1.0, 0.75]\n"
            "at              = [0, 0, 0]\n"
            "centre_of_mass  = [0, 0, 0.5]\n"
            "rotation_vector = [0, \"pi/3\", 0]\n"
            "angular_velocity_material = [0, 0, 50]\n"};
    return table;
}

}  // namespace gxrod
