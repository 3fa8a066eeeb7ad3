#include <fmt/format.h>

#include <cmath>

#include "deck/checks/check_memory.hpp"
#include "deck/schema/choices.hpp"
#include "deck/schema/schema_tables.hpp"

// [rod.NAME].
namespace gxrod {
namespace {

std::string describe_memory_of_largest_rod() {
    return fmt::format("{} elements already need more than {:.0f} GB of memory",
                       largest_element_count,
                       least_bytes_of_node() * static_cast<double>(largest_element_count) / 1e9);
}

KeySpec vector_key(const char* name, const char* dimension, Presence presence, const char* sentence) {
    return {.name = name,
            .type = ValueType::vector,
            .dimension = dimension,
            .presence = presence,
            .sentence = sentence};
}

KeySpec place_key(const char* name, const char* sentence) {
    return vector_key(name, "length", Presence::required, sentence);
}

KeySpec table_key(const char* name, const TableSpec& table, const char* sentence) {
    return {.name = name, .type = ValueType::table, .sentence = sentence, .table = &table};
}

const TableSpec& section_file_table() {
    static const TableSpec table{
        .path = "rod.NAME.sections",
        .heading = "sections = { … }",
        .sentence = "",
        .keys = {{.name = "file",
                  .type = ValueType::text,
                  .presence = Presence::required,
                  .sentence =
                      "A CSV file with a row for each station, relative to the deck's folder. A first line "
                      "names its columns: fraction, from 0 to 1; twist, if given, as the key twist; K11 K12 "
                      "… K66, the stiffness on and above the diagonal; M11 … M66, the inertia. Entries off "
                      "the diagonal without a column are 0. [Sections](guide/sections.md) has an example."},
                 table_key("damping", damping_table(), "Of the rod; none if left out.")}};
    return table;
}

const TableSpec& line_table() {
    static const TableSpec table{
        .path = "rod.NAME.line",
        .heading = "line = { … }",
        .sentence = "",
        .keys = {place_key("from", "Where the rod starts."), place_key("to", "Where it ends.")}};
    return table;
}

const TableSpec& arc_table() {
    static const TableSpec table{
        .path = "rod.NAME.arc",
        .heading = "arc = { … }",
        .sentence = "",
        .keys = {place_key("from", "Where the arc starts."),
                 vector_key("through", "length", Presence::optional, "A point between its ends."),
                 {.name = "to",
                  .type = ValueType::vector,
                  .dimension = "length",
                  .presence = Presence::required,
                  .sentence = "Where it ends.",
                  .only_with = "through"},
                 vector_key("centre", "length", Presence::optional, "Its centre."),
                 {.name = "axis",
                  .type = ValueType::vector,
                  .dimension = "1",
                  .presence = Presence::required,
                  .sentence = "Normal to its plane.",
                  .only_with = "centre"},
                 {.name = "angle",
                  .type = ValueType::number,
                  .dimension = "angle",
                  .range = {.lower = -2.0 * M_PI, .upper = 2.0 * M_PI},
                  .presence = Presence::required,
                  .sentence = "Turned about the axis from start to end, right-handed; \"2*pi\" is a circle.",
                  .only_with = "centre"}},
        .groups = {{GroupRule::exactly_one, {"through", "centre"}}}};
    return table;
}

const TableSpec& helix_table() {
    static const TableSpec table{
        .path = "rod.NAME.helix",
        .heading = "helix = { … }",
        .sentence = "",
        .keys = {
            place_key("centre", "A point of the axis."),
            vector_key("axis", "1", Presence::required, "Its direction."),
            place_key("from", "Where the rod starts; its distance from the axis is the radius."),
            {.name = "turns",
             .type = ValueType::number,
             .dimension = "1",
             .presence = Presence::required,
             .sentence = "About the axis from start to end, right-handed; any number but 0."},
            {.name = "pitch",
             .type = ValueType::number,
             .dimension = "length",
             .presence = Presence::required,
             .sentence = "Advance along the axis in each turn. The helix is left-handed if one of turns and "
                         "pitch is negative."}}};
    return table;
}

const TableSpec& catenary_table() {
    static const TableSpec table{
        .path = "rod.NAME.catenary",
        .heading = "catenary = { … }",
        .sentence = "",
        .keys = {place_key("from", "Where the rod starts."),
                 place_key("to", "Where it ends."),
                 {.name = "length",
                  .type = ValueType::number,
                  .dimension = "length",
                  .range = positive,
                  .presence = Presence::required,
                  .sentence = "Of the rod, more than there is between its ends."},
                 {.name = "bed",
                  .type = ValueType::flag,
                  .default_text = "false",
                  .sentence = "Whether what hangs below a horizontal [seabed] lies on it."}}};
    return table;
}

const TableSpec& mesh_table() {
    static const TableSpec table{
        .path = "rod.NAME.mesh",
        .heading = "mesh = { … }",
        .sentence = "",
        .keys = {
            {.name = "file",
             .type = ValueType::text,
             .presence = Presence::required,
             .sentence = "A Gmsh file: .msh of any version, or .geo, which is meshed. Relative to the deck's "
                         "folder."},
            {.name = "group",
             .type = ValueType::mesh_group,
             .presence = Presence::required,
             .sentence = "The physical group of its line elements, of order 1 to 3."}}};
    return table;
}

}  // namespace

std::vector<KeySpec> curve_keys() {
    return {
        table_key("line", line_table(), "The centreline: straight."),
        table_key(
            "arc", arc_table(), "A circular arc: from, through and to; or centre, axis, from and angle."),
        table_key("helix", helix_table(), "A circular helix."),
        {.name = "polyline",
         .type = ValueType::vectors,
         .dimension = "length",
         .sentence = "Straight pieces between points, meeting in rigid corners with a node each."},
        {.name = "spline",
         .type = ValueType::vectors,
         .dimension = "length",
         .sentence = "The natural cubic spline through points, its parameter the length of the chords."},
        table_key("catenary",
                  catenary_table(),
                  "As a line hangs between two points, z up. A rod that starts so is straight and without "
                  "twist where it is free of stress, if `rest` does not say otherwise.")};
}

namespace {

KeySpec y_axis_key(const char* default_text, const char* sentence) {
    return {.name = "y_axis",
            .type = ValueType::vector,
            .dimension = "1",
            .default_text = default_text,
            .sentence = sentence};
}

const TableSpec& rest_table() {
    static const TableSpec table = [] {
        std::vector<KeySpec> keys = curve_keys();
        keys.insert(
            keys.begin(),
            {.name = "curvature",
             .type = ValueType::place_vector,
             .dimension = "angle/length",
             .sentence = "Of a rest as long as the start, in section axes: the twist per length, and the "
                         "curvatures about y and z, as functions of s, the arc length, or of the place at "
                         "t = 0. [0, 0, 0] is straight and without twist."});
        keys.push_back(y_axis_key("that of the rod",
                                  "Section y at the start of a rest that is a curve, as in the rod itself."));
        keys.push_back({.name = "twist",
                        .type = ValueType::profile,
                        .dimension = "angle",
                        .default_text = "that of the rod",
                        .sentence = "Of a rest that is a curve, as in the rod itself."});
        return TableSpec{
            .path = "rod.NAME.rest",
            .heading = "rest = { … }",
            .sentence = "",
            .keys = std::move(keys),
            .groups = {{GroupRule::exactly_one,
                        {"curvature", "line", "arc", "helix", "polyline", "spline", "catenary"}}}};
    }();
    return table;
}

std::vector<KeySpec> rod_keys() {
    std::vector<KeySpec> keys = curve_keys();
    keys.push_back(table_key("mesh", mesh_table(), "The line elements of a mesh."));
    keys.insert(
        keys.begin(),
        {{.name = "section",
          .type = ValueType::reference,
          .sentence = "The name of a [section.NAME].",
          .refers_to = {"section"}},
         {.name = "sections",
          .type = ValueType::stations,
          .sentence = "In place of section, sections along the rod: fractions of its length and names. "
                      "Between them the 6×6 matrices are linear, entry by entry; where a fraction stands "
                      "twice they jump, and a node is placed. Or a table that names a file of them.",
          .table = &section_file_table()}});
    keys.push_back(
        {.name = "elements",
         .type = ValueType::integer,
         .range = {.lower = 1, .upper = static_cast<double>(largest_element_count)},
         .default_text = "needed, but for a mesh",
         .sentence =
             "How many, of equal length if `spacing` does not say otherwise; between corners and points "
             "NAME@FRACTION in proportion to length.",
         .above_range = describe_memory_of_largest_rod()});
    keys.push_back({.name = "spacing",
                    .type = ValueType::fraction_rows,
                    .dimension = "1",
                    .range = positive,
                    .default_text = "even",
                    .sentence =
                        "How long the elements are at fractions of the rod's length, compared with each "
                        "other; linear between the rows, with a jump where a fraction stands twice. "
                        "[[0, 1], [0.2, 10], [1, 10]] makes them a tenth as long at the start. For boundary "
                        "layers and where a line touches the ground."});
    keys.push_back({.name = "order",
                    .type = ValueType::integer,
                    .range = {.lower = 1, .upper = 4},
                    .default_value = static_cast<long>(Rod{}.order),
                    .sentence = "Nodes per element − 1. A mesh has its own."});
    keys.push_back({.name = "element",
                    .type = ValueType::choice,
                    .default_value = word_of(element_kind_choices, Rod{}.kind),
                    .sentence =
                        "objective: rotations relative to a triad of the element interpolated (Crisfield and "
                        "Jelenić 1999). simo: incremental rotation vectors interpolated (Simo and Vu-Quoc "
                        "1986).",
                    .choices = words_of(element_kind_choices)});
    keys.push_back(y_axis_key("the global axis least aligned with the rod",
                              "Section y at the start, projected perpendicular to the rod and carried along "
                              "it without twisting."));
    keys.push_back({.name = "twist",
                    .type = ValueType::profile,
                    .dimension = "angle",
                    .default_value = 0.0,
                    .sentence = "Turn of the section about the tangent from start to end, even along the "
                                "length, right-handed; free of stress. Or the turn at fractions of the "
                                "length, linear between them, from y_axis on."});
    keys.push_back(
        table_key("rest",
                  rest_table(),
                  "The shape in which the rod is free of stress, where that is not the one in "
                  "which it starts: its curvature, or a curve. Only the curve's shape counts, not where it "
                  "is; fractions of its length are those of the rod, and the rod's arc length, mass and "
                  "stiffness are by it. Left out, the rod starts free of stress, but for a catenary, which "
                  "is straight then."));
    return keys;
}

}  // namespace

const TableSpec& rod_table() {
    static const TableSpec table{
        .path = "rod.NAME",
        .heading = "[rod.NAME]",
        .sentence =
            "A rod. Its points are NAME.start, NAME.end and NAME@FRACTION, a fraction of the "
            "length from 0 to 1, where a node is placed, but for a history. [Geometry](guide/geometry.md) "
            "shows each shape and "
            "the points of a mesh.",
        .keys = rod_keys(),
        .groups = {{GroupRule::exactly_one, {"section", "sections"}},
                   {GroupRule::exactly_one,
                    {"line", "arc", "helix", "polyline", "spline", "catenary", "mesh"}}},
        .example =
            "[rod.flyer]\n"
            "section  = \"tube\"\n"
            "line     = { from = [6, 0, 0], to = [0, 8, 0] }\n"
            "elements = 10\n"
            "spacing  = [[0, 1], [0.5, 4], [1, 4]]\n"
            "y_axis   = [0, 0, 1]\n"
            "\n"
            "[rod.spring]\n"
            "section  = \"wire\"\n"
            "helix    = { centre = [0, 0, 0], axis = [0, 0, 1], from = [0.05, 0, 0], turns = 3, pitch = 0.05 "
            "}\n"
            "elements = 24\n"
            "order    = 3\n"
            "\n"
            "[rod.bow]\n"
            "section  = \"wire\"\n"
            "arc      = { from = [1, 0, 0], through = [0, 0, 1], to = [-1, 0, 0] }\n"
            "elements = 8\n"
            "order    = 2\n"
            "element  = \"simo\"\n"
            "\n"
            "[rod.frame]\n"
            "section  = \"laminate\"\n"
            "polyline = [[0, 0, 0], [0, 0, 2], [1, 0, 2]]\n"
            "elements = 6\n"
            "y_axis   = [0, 1, 0]\n"
            "twist    = \"pi/2\"\n"};
    return table;
}

}  // namespace gxrod
