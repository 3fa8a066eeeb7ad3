#include "deck/schema/choices.hpp"
#include "deck/schema/schema_tables.hpp"

// law of [section.NAME].
namespace gxrod {
namespace {

constexpr Range not_negative{.lower = 0.0};
constexpr const char* of_stiffness = "of stiffness";
constexpr const char* of_resultant = "of force or moment";

const TableSpec& layer_table() {
    static const TableSpec table{
        .path = "section.NAME.law.layers",
        .heading = "layers = [{ … }, …]",
        .sentence = "",
        .keys = {
            {.name = "on",
             .type = ValueType::choice,
             .presence = Presence::required,
             .sentence = "The strains that it takes part in. Of bending and shear it resists both, up to "
                         "a limit of their resultant.",
             .choices = words_of(strain_part_choices)},
            {.name = "stiffness",
             .type = ValueType::number,
             .dimension = of_stiffness,
             .range = positive,
             .presence = Presence::required,
             .sentence = "What it adds to the section's stiffness until it slips."},
            {.name = "limit",
             .type = ValueType::number,
             .dimension = of_resultant,
             .range = not_negative,
             .presence = Presence::required,
             .sentence = "The force or moment at which it slips."},
            {.name = "limit_per_tension",
             .type = ValueType::number,
             .dimension = "1 or length",
             .range = not_negative,
             .default_value = 0.0,
             .sentence = "What the limit grows by with the axial force, where that is tension."}}};
    return table;
}

KeySpec curve_key(const char* name, const char* sentence) {
    return {.name = name,
            .type = ValueType::pairs,
            .dimension = "1/length, moment",
            .range = not_negative,
            .sentence = sentence};
}

const TableSpec& moment_curvature_table() {
    static const TableSpec table{
        .path = "section.NAME.law.moment_curvature",
        .heading = "moment_curvature = { … }",
        .sentence = "",
        .keys = {curve_key("table",
                           "Rows [curvature, moment] from [0, 0] on, linear in between and beyond: of "
                           "bending in any direction. EIy and EIz are not used then."),
                 curve_key("y", "The same of bending about y alone, in place of EIy."),
                 curve_key("z", "The same of bending about z alone, in place of EIz."),
                 {.name = "hysteresis",
                  .type = ValueType::choice,
                  .default_value = "none",
                  .sentence = "Whether the moment follows the table back, or the section yields at each kink "
                              "and hardens kinematically.",
                  .choices = words_of(hysteresis_choices)}},
        .groups = {{GroupRule::at_least_one, {"table", "y", "z"}},
                   {GroupRule::at_most_one, {"table", "y"}},
                   {GroupRule::at_most_one, {"table", "z"}}}};
    return table;
}

KeySpec yield_key(const char* name, const char* dimension, const char* sentence) {
    return {.name = name,
            .type = ValueType::number,
            .dimension = dimension,
            .range = positive,
            .sentence = sentence};
}

const TableSpec& yield_table() {
    static const TableSpec table{
        .path = "section.NAME.law.plastic.yield",
        .heading = "yield = { … }",
        .sentence = "",
        .keys = {yield_key("N", "force", "Axial force at which it yields. What is left out does not yield."),
                 yield_key("Vy", "force", "Shear force along y."),
                 yield_key("Vz", "force", "Shear force along z."),
                 yield_key("T", "moment", "Torque."),
                 yield_key("My", "moment", "Bending moment about y."),
                 yield_key("Mz", "moment", "Bending moment about z.")},
        .groups = {{GroupRule::at_least_one, {"N", "Vy", "Vz", "T", "My", "Mz"}}}};
    return table;
}

const TableSpec& plastic_table() {
    static const TableSpec table{
        .path = "section.NAME.law.plastic",
        .heading = "plastic = { … }",
        .sentence = "",
        .keys = {{.name = "yield",
                  .type = ValueType::table,
                  .presence = Presence::required,
                  .sentence = "Resultants at which the section yields.",
                  .table = &yield_table()},
                 {.name = "interaction",
                  .type = ValueType::choice,
                  .default_value = "ellipsoid",
                  .sentence = "Whether it yields where the squares of resultants over their limits add up to "
                              "1, or each yields by itself.",
                  .choices = words_of(yield_interaction_choices)},
                 {.name = "isotropic",
                  .type = ValueType::number_or_pairs,
                  .dimension = "1",
                  .range = not_negative,
                  .default_text = "0",
                  .sentence = "How much all limits grow, over themselves, per plastic strain in multiples of "
                              "the strain at yield; or rows [that plastic strain, factor on limits] from "
                              "[0, 1] on."},
                 {.name = "kinematic",
                  .type = ValueType::number,
                  .dimension = "1",
                  .range = not_negative,
                  .default_value = 0.0,
                  .sentence = "Resultants move the yield surface by kinematic × stiffness × plastic "
                              "strain."}}};
    return table;
}

const TableSpec& viscoelastic_table() {
    static const TableSpec table{
        .path = "section.NAME.law.viscoelastic",
        .heading = "viscoelastic = { … }",
        .sentence = "",
        .keys = {{.name = "prony",
                  .type = ValueType::pairs,
                  .dimension = "1, time",
                  .range = not_negative,
                  .presence = Presence::required,
                  .sentence = "Rows [r, tau]: after a sudden strain the stiffness is that of the section, "
                              "which is the relaxed one, × (1 + Σ r exp(−t/tau))."},
                 {.name = "on",
                  .type = ValueType::choices,
                  .default_text = "all strains",
                  .sentence = "The strains that relax.",
                  .choices = words_of(strain_part_choices)}}};
    return table;
}

KeySpec kind_key(const char* name, const TableSpec& table, ValueType type, const char* sentence) {
    return {.name = name, .type = type, .sentence = sentence, .table = &table};
}

}  // namespace

const TableSpec& law_table() {
    static const TableSpec table{
        .path = "section.NAME.law",
        .heading = "law = { … }",
        .sentence = "",
        .keys = {kind_key("layers",
                          layer_table(),
                          ValueType::table_list,
                          "Springs that slip, next to the stiffness: friction of strands, plasticity."),
                 kind_key(
                     "moment_curvature", moment_curvature_table(), ValueType::table, "Moments by tables."),
                 kind_key("plastic", plastic_table(), ValueType::table, "Resultants that yield and harden."),
                 kind_key("viscoelastic",
                          viscoelastic_table(),
                          ValueType::table,
                          "Resultants that relax: a generalised Maxwell model.")},
        .groups = {{GroupRule::exactly_one, {"layers", "moment_curvature", "plastic", "viscoelastic"}}}};
    return table;
}

}  // namespace gxrod
