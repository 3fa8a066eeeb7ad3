#include "batch/plan/plan_schema.hpp"

#include "batch/plan/plan_tables.hpp"
#include "check/findings/found_values.hpp"
#include "deck/table/table.hpp"
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
    using T = UniformTable;
    // clang-format off
    static const TableSpec table = Table<T>("vary.KEY.uniform", "Every value of a range is equally likely.")
        .key("from", &T::from, "Lower end.")
            .required()
        .key("to", &T::to, "Upper end.")
            .required();
    // clang-format on
    return table;
}

// Adds the keys after the mean, which both have.
TableSpec with_deviation(Table<NormalTable> table) {
    using T = NormalTable;
    // clang-format off
    return table
        .key("deviation", &T::deviation, "Standard deviation of the values themselves.")
            .above(0).required()
        .key("from", &T::from, "Values below are left out: the rest of the distribution is scaled up.")
        .key("to", &T::to, "Values above are left out, too.");
    // clang-format on
}

const TableSpec& normal_table() {
    using T = NormalTable;
    // clang-format off
    static const TableSpec table = with_deviation(
        Table<T>("vary.KEY.normal", "A normal (Gaussian) distribution.")
        .key("mean", &T::mean, "Of the values themselves.")
            .required());
    // clang-format on
    return table;
}

const TableSpec& lognormal_table() {
    using T = NormalTable;
    // clang-format off
    static const TableSpec table = with_deviation(
        Table<T>("vary.KEY.lognormal", "The logarithms of the values are normally distributed.")
        .key("mean", &T::mean, "Of the values themselves.")
            .above(0).required());
    // clang-format on
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

const TableSpec& damage_table() {
    using T = DamageTable;
    // clang-format off
    static const TableSpec table = Table<T>("collect.NAME.damage",
            "Miner's sum of the cycles that rainflow counting finds (ASTM E1049). A curve is a detail category, or one or two lines "
            "N = cycles (at/range)^slope.")
        .key("detail", &T::detail, "The detail category of EN 1993-1-9: the range at 2e6 cycles, in the unit of the quantity.")
            .above(0).also("category")
        .key("slope", &T::slope, "Of the line for ranges above `at`.")
            .unit("1").above(0)
        .key("cycles", &T::cycles, "How many are endured at the range `at`.")
            .unit("1").above(0).required().only_with("slope")
        .key("at", &T::at, "The range that is endured for `cycles`.")
            .above(0).required().only_with("slope")
        .key("second_slope", &T::second_slope, "Of the line for ranges below `at`.")
            .unit("1").above(0).otherwise("`slope`").only_with("slope")
        .key("limit", &T::limit, "Ranges at and below it do no damage.")
            .at_least(0).otherwise("0").only_with("slope")
        .key("factor", &T::factor, "Times the ranges, as a partial factor.")
            .unit("1").above(0)
        .key("ultimate", &T::ultimate, "The ultimate stress, by which means in tension count (Goodman); without it, means do not.")
            .above(0)
        .key("from", &T::from, "The time at which counting starts.")
            .unit("time").at_least(0)
        .exactly_one_of({"detail", "slope"});
    // clang-format on
    return table;
}

const TableSpec& equivalent_table() {
    using T = EquivalentTable;
    // clang-format off
    static const TableSpec table = Table<T>("collect.NAME.range", "")
        .key("slope", &T::slope, "Of the line in the S-N diagram: 3 to 5 for steel, about 10 for composites.")
            .unit("1").above(0).required()
        .key("cycles", &T::cycles, "How many of the equal cycles do the same damage; as many as the run has seconds for one a second.")
            .unit("1").above(0).required()
        .key("from", &T::from, "The time at which counting starts.")
            .unit("time").at_least(0);
    // clang-format on
    return table;
}

const TableSpec& collect_table() {
    using T = CollectTable;
    // clang-format off
    static const TableSpec table = Table<T>("[collect.NAME]",
            "One number of each case, a column NAME of the table; `NAME = { … }` below `[collect]` is the same. Of a "
            "case that fails it is that of the steps it did.")
        .key("history", &T::history, "Name of a `[[history]]` of the deck.")
        .key("quantity", &T::quantity, "One of the quantities that the history records.")
            .required().words(list_quantity_words()).only_with("history")
        .key("ledger", &T::ledger, "Of the whole model.")
            .words(ledger_words())
        .key("stage", &T::stage, "Name of a `[[stage]]` of the deck that finds shapes or goes along a path; its kind, "
             "if the deck has [analysis].")
        .key("found", &T::found, "What it finds: `frequency`, `omega`, `growth` of modes and eigenvalues, "
             "`damping_ratio` of eigenvalues, `unstable`, how many of these grow, `factor` of buckling, `load_factor` "
             "of critical points, `onset` and `onset_omega` of a sweep.")
            .required().words(found_words()).only_with("stage")
        .key("number", &T::number, "Which of them, in their order.")
            .between(1, 1e6).only_with("stage")
        .key("component", &T::component,
             "Of a vector, a quaternion, a stress or a place in a section, which need one; `magnitude` of vectors only.")
        .key("take", &T::take, "Over all accepted steps. `mean` and `rms` are those over the time, the value running "
             "straight from step to step; `max_abs` is the largest absolute value.")
        .key("at", &T::at, "The value at this time (load factor, in statics), linear between steps.")
            .unit("time").at_least(0)
        .key("damage", &T::damage, damage_table(), "The damage of the value's cycles over the accepted steps, by an S-N curve. Of a component, which has a sign; of stress in a history with `point`.")
        .key("range", &T::range, equivalent_table(), "The equivalent range of the value's cycles: of equal ones that do the same damage.")
        .key("reference", &T::reference, "If given, the column is the distance from it: the error, if it is exact.")
        .exactly_one_of({"history", "ledger", "stage"})
        .exactly_one_of({"take", "at", "damage", "range"}, {}, "history")
        .exactly_one_of({"take", "at", "damage", "range"}, {}, "ledger")
        .shown_by(
            "[collect]\n"
            "tip_peak = { history = \"tip\", quantity = \"position\", component = \"z\", take = \"max\" }\n"
            "energy = { ledger = \"energy_error\", take = \"max_abs\" }\n"
            "first = { stage = \"tones\", found = \"frequency\", number = 1 }\n"
            "life = { history = \"root_edge\", quantity = \"stress\", component = \"xx\", damage = { detail = 71e6 } }\n"
            "load = { history = \"root\", quantity = \"moment\", component = \"z\", range = { slope = 4, cycles = 600 } }\n");
    // clang-format on
    return table;
}

const TableSpec& keep_table() {
    using T = KeepTable;
    // clang-format off
    static const TableSpec table = Table<T>("[keep]",
            "What is kept of each case in addition to its row of the table.")
        .key("results", &T::results, "Which results files stay in `cases/`. With `none` no frames are made, which is "
             "fastest.")
        .shown_by("[keep]\nresults = \"failed\"\n");
    // clang-format on
    return table;
}

}  // namespace

const TableSpec& variation_table() {
    using T = VariationTable;
    const std::string sampled = "For combine `latin-hypercube`.";
    // clang-format off
    static const TableSpec table = [&] {
        TableSpec made = Table<T>("vary.KEY", "")
            .key("from", &T::from, "First of a range of values.")
            .key("to", &T::to, "Last of them.")
                .required().only_with("from")
            .key("count", &T::count, "How many, both ends included.")
                .between(2, largest_case_count).required().only_with("from")
            .key("spacing", &T::spacing, "Equal differences (default), or equal ratios.")
                .only_with("from")
            .key("uniform", &T::uniform, uniform_table(), sampled)
            .key("normal", &T::normal, normal_table(), sampled)
            .key("lognormal", &T::lognormal, lognormal_table(), sampled)
            .key("column", &T::column, "For combine `table`: the column of the file.")
            .exactly_one_of({"from", "uniform", "normal", "lognormal", "column"});
        made.heading = "[vary]";
        return made;
    }();
    // clang-format on
    return table;
}

const TableSpec& plan_schema() {
    using T = PlanTable;
    const std::vector<Condition> sampled{{"combine", {"latin-hypercube"}}};
    // clang-format off
    static const TableSpec root = Table<T>("", "Keys that stand before the first [table].")
        .key("deck", &T::deck, "The deck that is varied.")
            .required().also("model base template")
        .key("combine", &T::combine, "`grid` runs every combination, the last key changing fastest; `zip` takes the "
             "first values together, then the second ones …; `latin-hypercube` draws `count` samples, of each key one "
             "in each of `count` equally likely parts; `table` takes a row of `table` for each case.")
            .also("mode combination")
        .key("count", &T::count, "Number of samples.")
            .between(1, largest_case_count).required().only_for(sampled).also("samples n")
        .key("seed", &T::seed, "Another seed draws other samples; the same one draws the same on any machine. What is "
             "drawn for a key depends on its name, the seed and the count, not on the other keys.")
            .at_least(0).only_for(sampled)
        .key("table", &T::table, "A CSV file whose first line names its columns: keys of the deck, or any names where "
             "`[vary]` says which key takes which column.")
            .required().only_for({{"combine", {"table"}}})
        .key("time_limit", &T::time_limit, "Wall time of one case, after which it is ended.")
            .unit("seconds").above(0).otherwise("none").also("timeout")
        .key("memory_limit", &T::memory_limit, "Memory of one case, beyond which it is ended.")
            .unit("gigabytes").above(0).otherwise("the machine's, shared by the workers")
        .tables("vary", KeyShape::variations, vary_table())
            .also("sweep variations")
        .tables("collect", KeyShape::named_tables, collect_table())
            .also("measure measures")
        .key("keep", &T::keep, keep_table(), "")
        .shown_by(
            "deck = \"flying_rod.toml\"\n"
            "combine = \"grid\"\n"
            "time_limit = 600\n");
    // clang-format on
    return root;
}

std::string plan_reference() { return introduction + table_reference(plan_schema()); }

}  // namespace gxrod
