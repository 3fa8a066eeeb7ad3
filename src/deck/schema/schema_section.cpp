#include "deck/schema/schema_tables.hpp"

// [section.NAME].
namespace gxrod {
namespace {

constexpr const char* axial_stiffness = "mass·length/time²";
constexpr const char* bending_stiffness = "mass·length³/time²";

KeySpec positive_key(const char* name, const char* dimension, Presence presence, const char* sentence) {
    return {.name = name,
            .type = ValueType::arc_number,
            .dimension = dimension,
            .range = positive,
            .presence = presence,
            .sentence = sentence};
}

KeySpec stiffness_key(const char* name, const char* dimension, const char* sentence) {
    return positive_key(name, dimension, Presence::required, sentence);
}

KeySpec length_key(const char* name, const char* sentence) {
    return positive_key(name, "length", Presence::required, sentence);
}

KeySpec table_key(const char* name, const TableSpec& table, const char* sentence) {
    return {.name = name, .type = ValueType::table, .sentence = sentence, .table = &table};
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

KeySpec rotary_key(const char* name, const char* default_text, const char* sentence) {
    return {.name = name,
            .type = ValueType::arc_number,
            .dimension = "mass·length",
            .range = positive,
            .default_text = default_text,
            .sentence = sentence,
            .remark = no_inertia};
}

const TableSpec& inertia_table() {
    constexpr const char* needed = "0 if static, else required";
    static const TableSpec table{
        .path = "section.NAME.inertia",
        .heading = "inertia = { … }",
        .sentence = "",
        .keys = {positive_key("rhoA", "mass/length", Presence::required, "Mass per length."),
                 rotary_key("rhoJ", "rhoIy + rhoIz", "Rotary inertia per length about x."),
                 rotary_key("rhoIy", needed, "Rotary inertia per length about y."),
                 rotary_key("rhoIz", needed, "Rotary inertia per length about z.")}};
    return table;
}

const TableSpec& circle_table() {
    static const TableSpec table{.path = "section.NAME.shape.circle",
                                 .heading = "circle = { … }",
                                 .sentence = "",
                                 .keys = {length_key("radius", "Radius.")}};
    return table;
}

const TableSpec& tube_table() {
    static const TableSpec table{.path = "section.NAME.shape.tube",
                                 .heading = "tube = { … }",
                                 .sentence = "",
                                 .keys = {length_key("outer_radius", "Outer radius."),
                                          length_key("inner_radius", "Inner radius, below the outer one.")}};
    return table;
}

const TableSpec& rectangle_table() {
    static const TableSpec table{
        .path = "section.NAME.shape.rectangle",
        .heading = "rectangle = { … }",
        .sentence = "",
        .keys = {length_key("width_y", "Side along y."), length_key("height_z", "Side along z.")}};
    return table;
}

const TableSpec& shape_table() {
    static const TableSpec table{
        .path = "section.NAME.shape",
        .heading = "shape = { … }",
        .sentence = "",
        .keys = {table_key("circle", circle_table(), "A solid circle."),
                 table_key("tube", tube_table(), "A hollow circle."),
                 table_key("rectangle", rectangle_table(), "A solid rectangle with sides along y and z.")},
        .groups = {{GroupRule::exactly_one, {"circle", "tube", "rectangle"}}}};
    return table;
}

const TableSpec& material_table() {
    static const TableSpec table{
        .path = "section.NAME.material",
        .heading = "material = { … }",
        .sentence = "",
        .keys = {positive_key("E", "mass/(length·time²)", Presence::required, "Young's modulus."),
                 {.name = "nu",
                  .type = ValueType::arc_number,
                  .dimension = "1",
                  .range = {.lower = -1.0, .at_lower = Bound::open, .upper = 0.5},
                  .sentence = "Poisson's ratio; G is E/(2(1 + nu))."},
                 positive_key("G", "mass/(length·time²)", Presence::optional, "Shear modulus."),
                 {.name = "yield_stress",
                  .type = ValueType::number,
                  .dimension = "mass/(length·time²)",
                  .range = positive,
                  .sentence = "Beyond it the material yields perfectly, and at 1/√3 of it in shear: bending, "
                              "torsion and tension each by itself "
                              "([materials](guide/materials.md#yield-stress-of-a-material))."},
                 {.name = "density",
                  .type = ValueType::arc_number,
                  .dimension = "mass/length³",
                  .range = positive,
                  .default_text = "none if static, else required",
                  .sentence = "Mass per volume."},
                 {.name = "shear_factor",
                  .type = ValueType::arc_number,
                  .dimension = "1",
                  .range = positive,
                  .default_text = "exact, for the shape and nu",
                  .sentence = "Shear stiffness is shear_factor G A along y and z. Left out, it follows from "
                              "the energy of "
                              "Saint-Venant's flexure ([shear stiffness](theory/shear_stiffness.md)), and "
                              "a rectangle has one along y and another along z."}},
        .groups = {{GroupRule::exactly_one, {"nu", "G"}}}};
    return table;
}

}  // namespace

const TableSpec& damping_table() {
    static const TableSpec table{
        .path = "section.NAME.damping",
        .heading = "damping = { … }",
        .sentence = "",
        .keys = {
            {.name = "kelvin_voigt",
             .type = ValueType::number_or_six,
             .dimension = "time",
             .range = {.lower = 0.0},
             .default_text = "0",
             .sentence = "Resultants are the stiffness times strain + kelvin_voigt × rate of the strain. Six "
                         "numbers, for extension, shear along y and z, torsion and bending about y and z, "
                         "damp each by its own: √(τᵢ τⱼ) Kᵢⱼ in place of τ Kᵢⱼ."},
            {.name = "mass_proportional",
             .type = ValueType::number,
             .dimension = "1/time",
             .range = {.lower = 0.0},
             .default_value = 0.0,
             .sentence = "Forces and couples are −mass_proportional × the momenta, per length."}}};
    return table;
}

const TableSpec& section_table() {
    static const TableSpec table{
        .path = "section.NAME",
        .heading = "[section.NAME]",
        .sentence =
            "A cross-section in its own axes: x along the tangent of the rod, y and z across. Stiffness and "
            "inertia come from constants, from matrices or from a shape and its material; a static analysis "
            "needs no inertia. Numbers can be functions of s, the arc length from the start of each rod that "
            "has the "
            "section. Rows and columns of matrices are in the order x y z rx ry rz. "
            "[Sections](guide/sections.md) has the formulas.",
        .keys = {table_key("stiffness", stiffness_table(), "Resultants from strains."),
                 {.name = "stiffness_matrix",
                  .type = ValueType::section_matrix,
                  .dimension = "of stiffness",
                  .sentence = "The same as a full matrix: symmetric, positive definite."},
                 table_key("shape", shape_table(), "Stiffness and inertia from the shape, with material."),
                 table_key("inertia", inertia_table(), "Momenta per length from velocities."),
                 {.name = "mass_matrix",
                  .type = ValueType::section_matrix,
                  .dimension = "of inertia",
                  .sentence =
                      "The same as a full matrix: that of a rigid slice, [m 1, −m [d]×; m [d]×, J] with d "
                      "from the node to the centre of mass and J about the node; positive definite."},
                 {.name = "material",
                  .type = ValueType::table,
                  .presence = Presence::required,
                  .sentence = "What the shape is made of.",
                  .only_with = "shape",
                  .table = &material_table()},
                 {.name = "at",
                  .type = ValueType::section_point,
                  .dimension = "length",
                  .default_text = "[0, 0]",
                  .sentence = "Where the point is, from the rod and in its section axes, about which "
                              "stiffness and inertia are given, or in which the middle of the shape lies. "
                              "They are moved from there to the rod, exactly."},
                 {.name = "turn",
                  .type = ValueType::arc_number,
                  .dimension = "angle",
                  .default_value = 0.0,
                  .sentence = "Of the axes in which they are given, from the rod's about x, right-handed: "
                              "from y towards z. Also of the shape."},
                 table_key("damping", damping_table(), "None if left out."),
                 table_key("law", law_table(), "Linear and elastic if left out."),
                 {.name = "trapeze",
                  .type = ValueType::flag,
                  .default_text = "false",
                  .sentence =
                      "Whether twist pulls the section together, as BeamDyn has it: with c = EIy + EIz, "
                      "½ c twist² of axial force and c × twist × extension of torque."},
                 {.name = "expansion",
                  .type = ValueType::arc_number,
                  .dimension = "1/temperature",
                  .default_value = 0.0,
                  .sentence = "Strain by heat, for the temperatures of [[actuation]]."},
                 {.name = "radius",
                  .type = ValueType::number,
                  .dimension = "length",
                  .range = positive,
                  .default_text =
                      "of a circle or a tube its outer radius; else half of fluid's outer_diameter",
                  .sentence = "Of contact: what touches is round."},
                 table_key("fluid",
                           section_fluid_table(),
                           "What [fluid], [air] and [seabed] see of it; {} takes part with the defaults. "
                           "Without it they pass it by.")},
        .groups = {{GroupRule::exactly_one, {"stiffness", "stiffness_matrix", "shape"}},
                   {GroupRule::at_most_one, {"inertia", "mass_matrix", "material"}}},
        .example =
            "[section.tube]\n"
            "stiffness = { EA = 1e4, GAy = 1e4, GAz = 1e4, GJ = \"GJ\", EIy = \"EI\", EIz = \"EI\" }\n"
            "inertia   = { rhoA = 1.0, rhoJ = 20.0, rhoIy = 10.0, rhoIz = 10.0 }\n"
            "damping   = { kelvin_voigt = 1e-3 }\n"
            "\n"
            "[section.wire]\n"
            "shape    = { circle = { radius = 5e-3 } }\n"
            "material = { E = 2.1e11, nu = 0.3, density = 7850 }\n"
            "fluid    = { drag = 1.0 }\n"
            "\n"
            "[section.strand]\n"
            "stiffness = { EA = 1e4, GAy = 1e4, GAz = 1e4, GJ = 300, EIy = 800, EIz = 800 }\n"
            "inertia   = { rhoA = 1.0, rhoIy = 10.0, rhoIz = 10.0 }\n"
            "law       = { layers = [{ on = \"bending\", stiffness = 4200, limit = 120 }] }\n"
            "\n"
            "[section.laminate]\n"
            "stiffness_matrix = [\n"
            "  [1e6,   0,   0,   0,   0,   0],\n"
            "  [  0, 4e5,   0,   0,   0,   0],\n"
            "  [  0,   0, 4e5,   0,   0,   0],\n"
            "  [  0,   0,   0,  50,  10,   0],\n"
            "  [  0,   0,   0,  10,  80,   0],\n"
            "  [  0,   0,   0,   0,   0, 900]]\n"
            "mass_matrix = [\n"
            "  [ 2.0,   0,   0,    0,    0, -0.1],\n"
            "  [   0, 2.0,   0,    0,    0,    0],\n"
            "  [   0,   0, 2.0,  0.1,    0,    0],\n"
            "  [   0,   0, 0.1, 0.03,    0,    0],\n"
            "  [   0,   0,   0,    0, 0.02,    0],\n"
            "  [-0.1,   0,   0,    0,    0, 0.02]]\n"};
    return table;
}

}  // namespace gxrod
