#include "batch/plan/plan_schema.hpp"

#include "batch/plan/plan_words.hpp"
#include "check/findings/found_values.hpp"
#include "deck/schema/choices.hpp"
#include "deck/schema/schema_tables.hpp"
#include "results/tables/step_columns.hpp"
#include "watch/quantities.hpp"

namespace gxrod {
namespace {

constexpr const char* introduction =
    R"md(# Plan reference

A plan says which variants of a deck `gxrod batch` runs and what it collects of them. It is a
[TOML 1.0](https://toml.io) text. This page is written by `gxrod schema --plan --markdown`, from the declarations that
the reader itself checks a plan with; `gxrod schema --plan` writes the same as a JSON Schema for editors.
[Batches](guide/batch.md) is the guide.

- **Keys of the deck** stand in quotes, as `--set` takes them: `"analysis.time_step"`, `"parameters.EI"`,
  `"load[0].force"` (the first `[[load]]`), `"load[0].force[2]"` (its third component).
- **Files** are relative to the plan's folder.
- **Numbers** can be expressions in quotes, such as `"2*pi"`; a plan has no names of its own. Values that are given to
  the deck, the lists of `[vary]` and the cells of a table, are not evaluated here but by the deck: there `"2*EI"` has
  the deck's parameters.

)md";

std::vector<std::string> ledger_words() {
    std::vector<std::string> words;
    for (const LedgerColumn& column : ledger_columns) words.emplace_back(column.name);
    return words;
}

std::vector<std::string> found_words() { return {found_quantities.begin(), found_quantities.end()}; }

const TableSpec& uniform_table() {
    static const TableSpec table{.path = "vary.KEY.uniform",
                                 .heading = "uniform = { … }",
                                 .sentence = "Every value of a range is equally likely.",
                                 .keys = {{.name = "from",
                                           .type = ValueType::number,
                                           .presence = Presence::required,
                                           .sentence = "Lower end."},
                                          {.name = "to",
                                           .type = ValueType::number,
                                           .presence = Presence::required,
                                           .sentence = "Upper end."}}};
    return table;
}

std::vector<KeySpec> moment_keys(const Range& mean) {
    return {{.name = "mean",
             .type = ValueType::number,
             .range = mean,
             .presence = Presence::required,
             .sentence = "Of the values themselves."},
            {.name = "deviation",
             .type = ValueType::number,
             .range = positive,
             .presence = Presence::required,
             .sentence = "Standard deviation of the values themselves."},
            {.name = "from",
             .type = ValueType::number,
             .sentence = "Values below are left out: the rest of the distribution is scaled up."},
            {.name = "to", .type = ValueType::number, .sentence = "Values above are left out, too."}};
}

const TableSpec& normal_table() {
    static const TableSpec table{.path = "vary.KEY.normal",
                                 .heading = "normal = { … }",
                                 .sentence = "A normal (Gaussian) distribution.",
                                 .keys = moment_keys({})};
    return table;
}

const TableSpec& lognormal_table() {
    static const TableSpec table{.path = "vary.KEY.lognormal",
                                 .heading = "lognormal = { … }",
                                 .sentence = "The logarithms of the values are normally distributed.",
                                 .keys = moment_keys(positive)};
    return table;
}

const TableSpec& vary_table() {
    static const TableSpec table = [] {
        TableSpec vary = variation_table();
        vary.path = "vary";
        vary.heading = "[vary]";
        vary.sentence =
            "What differs from case to case: any keys of the deck, in quotes. `KEY = [value, value, …]` "
            "lists values, of any type; `KEY = { … }` has the keys below.";
        vary.example =
            "[vary]\n"
            "\"parameters.EI\" = [100, 200, 500]\n"
            "\"analysis.time_step\" = { from = 0.1, to = 0.001, count = 5, spacing = \"log\" }\n";
        return vary;
    }();
    return table;
}

// Of what a stage finds.
std::vector<KeySpec> found_keys() {
    return {{.name = "stage",
             .type = ValueType::text,
             .sentence = "Name of a `[[stage]]` of the deck that finds shapes or goes along a path; its "
                         "kind, if the deck has [analysis]."},
            {.name = "found",
             .type = ValueType::choice,
             .presence = Presence::required,
             .sentence = "What it finds: `frequency`, `omega`, `growth` of modes and eigenvalues, "
                         "`damping_ratio` of eigenvalues, `unstable`, how many of these grow, `factor` of "
                         "buckling, `load_factor` of critical points, `onset` and `onset_omega` of a sweep.",
             .choices = found_words(),
             .only_with = "stage"},
            {.name = "number",
             .type = ValueType::integer,
             .range = {.lower = 1, .upper = 1e6},
             .default_value = 1L,
             .sentence = "Which of them, in their order.",
             .only_with = "stage"}};
}

const TableSpec& collect_table() {
    static const TableSpec table = [] {
        TableSpec collect{
            .path = "collect.NAME",
            .heading = "[collect.NAME]",
            .sentence =
                "One number of each case, a column NAME of the table; `NAME = { … }` below `[collect]` is "
                "the "
                "same. Of a case that fails it is that of the steps it did.",
            .keys =
                {{.name = "history",
                  .type = ValueType::text,
                  .sentence = "Name of a `[[history]]` of the deck."},
                 {.name = "quantity",
                  .type = ValueType::choice,
                  .presence = Presence::required,
                  .sentence = "One of the quantities that the history records.",
                  .choices = list_quantity_words(),
                  .only_with = "history"},
                 {.name = "ledger",
                  .type = ValueType::choice,
                  .sentence = "Of the whole model.",
                  .choices = ledger_words()},
                 {.name = "component",
                  .type = ValueType::choice,
                  .sentence = "Of a vector or quaternion, which need one; `magnitude` of vectors only.",
                  .choices = words_of(component_choices)},
                 {.name = "take",
                  .type = ValueType::choice,
                  .sentence =
                      "Over all accepted steps. `mean` and `rms` are those over the time, the value running "
                      "straight from step to step; `max_abs` is the largest absolute value.",
                  .choices = words_of(take_choices)},
                 {.name = "at",
                  .type = ValueType::number,
                  .dimension = "time",
                  .range = {.lower = 0.0},
                  .sentence = "The value at this time (load factor, in statics), linear between steps."},
                 {.name = "reference",
                  .type = ValueType::number,
                  .sentence = "If given, the column is the distance from it: the error, if it is exact."}},
            .groups = {{GroupRule::exactly_one, {"history", "ledger", "stage"}},
                       {GroupRule::exactly_one, {"take", "at"}, {}, "history"},
                       {GroupRule::exactly_one, {"take", "at"}, {}, "ledger"}},
            .example =
                "[collect]\n"
                "tip_peak = { history = \"tip\", quantity = \"position\", component = \"z\", take = \"max\" "
                "}\n"
                "energy = { ledger = \"energy_error\", take = \"max_abs\" }\n"
                "first = { stage = \"tones\", found = \"frequency\", number = 1 }\n"};
        std::vector<KeySpec> found = found_keys();
        collect.keys.insert(collect.keys.begin() + 3, found.begin(), found.end());
        return collect;
    }();
    return table;
}

const TableSpec& keep_table() {
    static const TableSpec table{
        .path = "keep",
        .heading = "[keep]",
        .sentence = "What is kept of each case in addition to its row of the table.",
        .keys =
            {{.name = "results",
              .type = ValueType::choice,
              .default_value = "all",
              .sentence =
                  "Which results files stay in `cases/`. With `none` no frames are made, which is fastest.",
              .choices = words_of(keeping_choices)}},
        .example = "[keep]\nresults = \"failed\"\n"};
    return table;
}

TableSpec make_root() {
    const std::vector<Condition> sampled{{"combine", {"latin-hypercube"}}};
    TableSpec root;
    root.sentence = "Keys that stand before the first [table].";
    root.keys = {
        {.name = "deck",
         .type = ValueType::text,
         .presence = Presence::required,
         .sentence = "The deck that is varied."},
        {.name = "combine",
         .type = ValueType::choice,
         .default_value = "grid",
         .sentence =
             "`grid` runs every combination, the last key changing fastest; `zip` takes the first values "
             "together, then the second ones …; `latin-hypercube` draws `count` samples, of each key one in "
             "each of `count` equally likely parts; `table` takes a row of `table` for each case.",
         .choices = words_of(combination_choices)},
        {.name = "count",
         .type = ValueType::integer,
         .range = {.lower = 1, .upper = largest_case_count},
         .presence = Presence::required,
         .sentence = "Number of samples.",
         .only_for = sampled},
        {.name = "seed",
         .type = ValueType::integer,
         .range = {.lower = 0},
         .default_value = 1L,
         .sentence = "Another seed draws other samples; the same one draws the same on any machine. What is "
                     "drawn for "
                     "a key depends on its name, the seed and the count, not on the other keys.",
         .only_for = sampled},
        {.name = "table",
         .type = ValueType::text,
         .presence = Presence::required,
         .sentence =
             "A CSV file whose first line names its columns: keys of the deck, or any names where `[vary]` "
             "says which key takes which column.",
         .only_for = {{"combine", {"table"}}}},
        {.name = "time_limit",
         .type = ValueType::number,
         .dimension = "seconds",
         .range = positive,
         .default_text = "none",
         .sentence = "Wall time of one case, after which it is ended."},
        {.name = "memory_limit",
         .type = ValueType::number,
         .dimension = "gigabytes",
         .range = positive,
         .default_text = "the machine's, shared by the workers",
         .sentence = "Memory of one case, beyond which it is ended."},
        {.name = "vary", .type = ValueType::variations, .table = &vary_table()},
        {.name = "collect", .type = ValueType::named_tables, .table = &collect_table()},
        {.name = "keep", .type = ValueType::table, .table = &keep_table()},
    };
    root.other_names = {{"vary", "sweep variations"},
                        {"deck", "model base template"},
                        {"combine", "mode combination"},
                        {"count", "samples n"},
                        {"collect", "measure measures"},
                        {"time_limit", "timeout"}};
    root.example =
        "deck = \"flying_rod.toml\"\n"
        "combine = \"grid\"\n"
        "time_limit = 600\n";
    return root;
}

}  // namespace

const TableSpec& variation_table() {
    static const TableSpec table{
        .path = "vary.KEY",
        .heading = "[vary]",
        .sentence = "",
        .keys = {{.name = "from", .type = ValueType::number, .sentence = "First of a range of values."},
                 {.name = "to",
                  .type = ValueType::number,
                  .presence = Presence::required,
                  .sentence = "Last of them.",
                  .only_with = "from"},
                 {.name = "count",
                  .type = ValueType::integer,
                  .range = {.lower = 2, .upper = largest_case_count},
                  .presence = Presence::required,
                  .sentence = "How many, both ends included.",
                  .only_with = "from"},
                 {.name = "spacing",
                  .type = ValueType::choice,
                  .sentence = "Equal differences (default), or equal ratios.",
                  .choices = words_of(spacing_choices),
                  .only_with = "from"},
                 {.name = "uniform",
                  .type = ValueType::table,
                  .sentence = "For combine `latin-hypercube`.",
                  .table = &uniform_table()},
                 {.name = "normal",
                  .type = ValueType::table,
                  .sentence = "For combine `latin-hypercube`.",
                  .table = &normal_table()},
                 {.name = "lognormal",
                  .type = ValueType::table,
                  .sentence = "For combine `latin-hypercube`.",
                  .table = &lognormal_table()},
                 {.name = "column",
                  .type = ValueType::text,
                  .sentence = "For combine `table`: the column of the file."}},
        .groups = {{GroupRule::exactly_one, {"from", "uniform", "normal", "lognormal", "column"}}}};
    return table;
}

const TableSpec& plan_schema() {
    static const TableSpec root = make_root();
    return root;
}

std::string plan_reference() { return introduction + table_reference(plan_schema()); }

}  // namespace gxrod
