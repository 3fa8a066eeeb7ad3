#include "deck/schema/choices.hpp"
#include "deck/schema/schema_tables.hpp"

// [fluid], [[wave]], [air], [seabed], and what water and air see of sections and bodies.
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

constexpr Range not_negative{.lower = 0.0};
constexpr const char* density_dimension = "mass/length³";
constexpr const char* pressure_dimension = "mass/(length·time²)";
constexpr const char* bed_dimension = "mass/(length²·time²)";

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

KeySpec vector_key(const char* name, const char* dimension, const char* sentence) {
    return {.name = name, .type = ValueType::vector, .dimension = dimension, .sentence = sentence};
}

KeySpec file_key(const char* sentence) {
    return {.name = "file", .type = ValueType::text, .presence = Presence::required, .sentence = sentence};
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

// Of a current or a wind.
TableSpec make_flow_table(const char* path, const char* heading, const std::string& what) {
    return {.path = path,
            .heading = heading,
            .sentence = "",
            .keys = {{.name = "table",
                      .type = ValueType::pairs,
                      .dimension = "length, length/time",
                      .sentence = "Rows of a height z and the speed there, z rising from row to row: linear "
                                  "between them, constant beyond."},
                     {.name = "direction",
                      .type = ValueType::vector,
                      .dimension = "1",
                      .presence = Presence::required,
                      .sentence = "Where it flows to, of any length.",
                      .only_with = "table"},
                     {.name = "velocity",
                      .type = ValueType::field_vector,
                      .dimension = "length/time",
                      .sentence = "By time and place, global components."},
                     factor_key(what),
                     stages_key("The stages in which it flows.")},
            .groups = {{GroupRule::exactly_one, {"table", "velocity"}}}};
}

const TableSpec& current_table() {
    static const TableSpec table = make_flow_table("fluid.current", "current = { … }", "current");
    return table;
}

const TableSpec& wind_table() {
    static const TableSpec table = make_flow_table("air.wind", "wind = { … }", "wind");
    return table;
}

const TableSpec& airy_table() {
    static const TableSpec table{
        .path = "wave.airy",
        .heading = "airy = { … }",
        .sentence = "",
        .keys = {required(number_key("height", "length", positive, "From trough to crest.")),
                 required(number_key("period", "time", positive, "Of a point at rest.")),
                 defaulted(number_key("phase",
                                      "angle",
                                      {},
                                      "At the origin the surface is height/2 cos(phase − ω t), t from the "
                                      "start of the first stage with time."),
                           0.0)}};
    return table;
}

const TableSpec& jonswap_table() {
    static const TableSpec table{
        .path = "wave.jonswap",
        .heading = "jonswap = { … }",
        .sentence = "",
        .keys = {required(number_key("Hs", "length", positive, "Significant height: 4 √(variance).")),
                 required(number_key("Tp", "time", positive, "Period of the peak.")),
                 defaulted(number_key("gamma",
                                      "1",
                                      {.lower = 1.0},
                                      "Peak enhancement; 1 is the spectrum of Pierson and Moskowitz."),
                           3.3),
                 {.name = "components",
                  .type = ValueType::integer,
                  .range = {.lower = 1, .upper = 100000},
                  .default_value = 200L,
                  .sentence = "How many waves of equal energy."},
                 {.name = "seed",
                  .type = ValueType::integer,
                  .range = {.lower = 0, .upper = 1e15},
                  .default_value = 1L,
                  .sentence = "Of the random phases: the same seed is the same sea on every machine."},
                 described(number_key("spreading",
                                      "1",
                                      not_negative,
                                      "s: directions spread about the given one as cos^2s of half the angle "
                                      "between."),
                           "none: all of one direction")}};
    return table;
}

const TableSpec& elevation_table() {
    static const TableSpec table{
        .path = "wave.elevation",
        .heading = "elevation = { … }",
        .sentence = "",
        .keys = {file_key("A CSV file of two columns, t and the height of the surface above still water, t "
                          "rising in equal steps; relative to the deck's folder."),
                 {.name = "at",
                  .type = ValueType::vector,
                  .dimension = "length",
                  .default_value = Vec3(0, 0, 0),
                  .sentence = "Where it was measured; its height says nothing."},
                 described(number_key("shortest_period", "time", positive, "Shorter waves are left out."),
                           "two steps of the record"),
                 described(number_key("longest_period", "time", positive, "Longer waves are left out."),
                           "the length of the record")}};
    return table;
}

const TableSpec& bed_plane_table() {
    static const TableSpec table{
        .path = "seabed.plane",
        .heading = "plane = { … }",
        .sentence = "",
        .keys = {required(vector_key("point", "length", "A point of the ground.")),
                 required(vector_key("normal", "1", "Out of the ground, of any length."))}};
    return table;
}

const TableSpec& bed_grid_table() {
    static const TableSpec table{
        .path = "seabed.grid",
        .heading = "grid = { … }",
        .sentence = "",
        .keys = {file_key("A CSV file of three columns, x, y and z, a row for each point of a grid in x and "
                          "y, in any order; relative to the deck's folder.")}};
    return table;
}

const TableSpec& friction_table() {
    static const TableSpec table{
        .path = "seabed.friction",
        .heading = "friction = { … }",
        .sentence = "",
        .keys = {
            required(number_key("axial", "1", not_negative, "Coulomb's coefficient along a rod.")),
            required(number_key("lateral", "1", not_negative, "Across it.")),
            described(
                number_key(
                    "stiffness", bed_dimension, positive, "Force per area and displacement until it slides."),
                "stiffness of the ground"),
            described(
                stages_key("The stages in which it acts; in others what lies slides freely, and friction "
                           "that begins later holds it where it is then."),
                "all but a first static one that others follow")}};
    return table;
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

const TableSpec& fluid_table() {
    static const TableSpec table{
        .path = "fluid",
        .heading = "[fluid]",
        .sentence =
            "The water around sections and bodies that have a key `fluid`. [Water, wind and "
            "ground](guide/water.md) explains it.",
        .keys = {required(number_key("density", density_dimension, positive, "Mass per volume.")),
                 described(
                     number_key("surface", "length", {}, "z of still water: up is z, and gravity acts down."),
                     "none: water everywhere"),
                 described(number_key("depth", "length", positive, "Of the water that waves feel."),
                           "down to a horizontal [seabed]; without one the water is deep"),
                 table_key("current", current_table(), "How it flows without waves; still if left out."),
                 {.name = "stretching",
                  .type = ValueType::choice,
                  .default_value = word_of(stretching_choices, Water{}.stretching),
                  .sentence = "How linear waves reach the moving surface. wheeler: the profile from bed to "
                              "still water is drawn out to it. vertical: above still water as at it. "
                              "extrapolate: along the tangent there. none: by the formulas of below.",
                  .choices = words_of(stretching_choices)},
                 {.name = "current_stretching",
                  .type = ValueType::flag,
                  .default_text = "false",
                  .sentence = "Whether the table of the current is drawn out to the surface, as by wheeler."},
                 defaulted(number_key("ramp",
                                      "time",
                                      not_negative,
                                      "How long waves take to grow, from the start of the first stage that "
                                      "has them."),
                           0.0)},
        .example =
            "[fluid]\n"
            "density = 1025\n"
            "surface = 20\n"
            "depth   = 100\n"
            "current = { table = [[-80, 0.2], [20, 1.2]], direction = [1, 0, 0] }\n"
            "ramp    = 5\n"};
    return table;
}

const TableSpec& wave_table() {
    static const TableSpec table{
        .path = "wave",
        .heading = "[[wave]]",
        .sentence = "Linear waves on the surface of [fluid], in stages that have time. Several add up.",
        .keys = {table_key("airy", airy_table(), "One regular wave."),
                 table_key("jonswap", jonswap_table(), "A sea by its spectrum."),
                 table_key("elevation", elevation_table(), "A record of the surface."),
                 {.name = "direction",
                  .type = ValueType::vector,
                  .dimension = "1",
                  .default_value = Vec3(1, 0, 0),
                  .sentence = "Where they go, horizontal and of any length."},
                 stages_key("The stages with waves, of those that have time.")},
        .groups = {{GroupRule::exactly_one, {"airy", "jonswap", "elevation"}}},
        .example =
            "[[wave]]\n"
            "airy      = { height = 2, period = 8 }\n"
            "direction = [0, 1, 0]\n"};
    return table;
}

const TableSpec& air_table() {
    static const TableSpec table{
        .path = "air",
        .heading = "[air]",
        .sentence =
            "The air around sections and bodies that have a key `fluid`, above the water if there is "
            "any.",
        .keys = {required(number_key("density", density_dimension, positive, "Mass per volume.")),
                 table_key("wind", wind_table(), "How it flows; still if left out.")},
        .example =
            "[air]\n"
            "density = 1.225\n"
            "wind    = { velocity = [\"10*(max(z - 20, 0.1)/10)^0.14\", 0, 0] }\n"};
    return table;
}

const TableSpec& seabed_table() {
    static const TableSpec table{
        .path = "seabed",
        .heading = "[seabed]",
        .sentence = "Ground, under water or not, that sections and bodies with a key `fluid` lie on.",
        .keys = {number_key("z", "length", {}, "The height of a horizontal plane."),
                 table_key("plane", bed_plane_table(), "A plane that is not."),
                 table_key("grid", bed_grid_table(), "Heights on a grid, linear between its points."),
                 required(number_key("stiffness",
                                     bed_dimension,
                                     positive,
                                     "Force per area and depth; the area is the diameter times the length.")),
                 defaulted(number_key("damping",
                                      "mass/(length²·time)",
                                      not_negative,
                                      "Force per area and speed, into the ground only."),
                           0.0),
                 number_or_table("friction",
                                 friction_table(),
                                 "0",
                                 "Coulomb's. A number is the coefficient along and across a rod.")},
        .groups = {{GroupRule::exactly_one, {"z", "plane", "grid"}}},
        .example =
            "[seabed]\n"
            "z         = -80\n"
            "stiffness = 1e5\n"
            "friction  = { axial = 0.3, lateral = 0.6 }\n"};
    return table;
}

}  // namespace gxrod
