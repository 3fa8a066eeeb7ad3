#include "deck/schema/choices.hpp"
#include "deck/schema/schema_tables.hpp"

// The keys of the response to forces that swing.
namespace gxrod {
namespace {

constexpr Range not_negative{.lower = 0.0};

TableSpec make_values(const char* name, const char* dimension) {
    return {.path = std::string("analysis.") + name,
            .heading = std::string(name) + " = { … }",
            .sentence = "",
            .keys = value_keys(dimension, not_negative, 100),
            .groups = {value_group()}};
}

const TableSpec& omega_table() {
    static const TableSpec table = make_values("omega", "angle/time");
    return table;
}

const TableSpec& frequency_table() {
    static const TableSpec table = make_values("frequency", "1/time");
    return table;
}

const TableSpec& excite_table() {
    static const TableSpec table{
        .path = "analysis.excite",
        .heading = "excite = [{ … }, …]",
        .sentence = "",
        .keys = {{.name = "at",
                  .type = ValueType::point,
                  .presence = Presence::required,
                  .sentence = "The point on which it acts."},
                 {.name = "force",
                  .type = ValueType::vector,
                  .dimension = "mass·length/time²",
                  .default_value = Vec3(0, 0, 0),
                  .sentence = "Amplitude of the force, global axes."},
                 {.name = "moment",
                  .type = ValueType::vector,
                  .dimension = "mass·length²/time²",
                  .default_value = Vec3(0, 0, 0),
                  .sentence = "Amplitude of the moment, global axes."},
                 {.name = "phase",
                  .type = ValueType::number,
                  .dimension = "angle",
                  .default_value = 0.0,
                  .sentence = "By which it is ahead, rad: it acts as cos(ωt + phase)."}},
        .groups = {{.rule = GroupRule::at_least_one, .keys = {"force", "moment"}}}};
    return table;
}

}  // namespace

std::vector<KeySpec> value_keys(const char* dimension, const Range& range, long count) {
    return {{.name = "from",
             .type = ValueType::number,
             .dimension = dimension,
             .range = range,
             .sentence = "The first."},
            {.name = "to",
             .type = ValueType::number,
             .dimension = dimension,
             .range = range,
             .presence = Presence::required,
             .sentence = "The last.",
             .only_with = "from"},
            {.name = "count",
             .type = ValueType::integer,
             .range = {.lower = 2, .upper = 1'000'000},
             .default_value = count,
             .sentence = "How many.",
             .only_with = "from"},
            {.name = "spacing",
             .type = ValueType::choice,
             .default_value = std::string("linear"),
             .sentence = "linear: equal steps; log: equal ratios.",
             .choices = {"linear", "log"},
             .only_with = "from"},
            {.name = "values",
             .type = ValueType::numbers,
             .dimension = dimension,
             .sentence = "Instead: these."}};
}

KeyGroup value_group() { return {.rule = GroupRule::exactly_one, .keys = {"from", "values"}}; }

std::vector<KeySpec> response_keys() {
    const Condition response_only{"kind", {"response"}};
    return {{.name = "omega",
             .type = ValueType::table,
             .sentence = "Of the forces, rad per time.",
             .only_for = {response_only},
             .table = &omega_table()},
            {.name = "frequency",
             .type = ValueType::table,
             .sentence = "The same in cycles per time.",
             .only_for = {response_only},
             .table = &frequency_table()},
            {.name = "excite",
             .type = ValueType::table_list,
             .presence = Presence::required,
             .sentence = "Forces that swing with the frequency; loads of the deck stay as they are.",
             .only_for = {response_only},
             .table = &excite_table()}};
}

}  // namespace gxrod
