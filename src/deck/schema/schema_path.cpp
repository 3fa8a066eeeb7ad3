#include "deck/schema/choices.hpp"
#include "deck/schema/schema_tables.hpp"

// The keys that a path has beyond those of other analyses.
namespace gxrod {
namespace {

constexpr Range positive_count{.lower = 1.0, .upper = static_cast<double>(largest_step_count)};

const TableSpec& until_table() {
    static const TableSpec table{
        .path = "analysis.until",
        .heading = "until = { … }",
        .sentence = "",
        .keys = {{.name = "t",
                  .type = ValueType::bounds,
                  .dimension = "1",
                  .sentence = "The load factor at which it ends: one bound, to which t goes from 0, or "
                              "`[lower, upper]`, of which t goes to the upper one first."},
                 {.name = "arc",
                  .type = ValueType::number,
                  .dimension = "1",
                  .range = positive,
                  .sentence = "The arc length at which it ends."},
                 {.name = "steps",
                  .type = ValueType::integer,
                  .range = positive_count,
                  .sentence = "The accepted steps after which it ends."},
                 {.name = "points",
                  .type = ValueType::integer,
                  .range = positive_count,
                  .sentence = "The limit points and bifurcations after which it ends."}},
        .groups = {{.rule = GroupRule::at_least_one, .keys = {"t", "arc", "steps", "points"}}}};
    return table;
}

const TableSpec& at_table() {
    static const TableSpec table{.path = "analysis.at",
                                 .heading = "at = [{ … }, …]",
                                 .sentence = "",
                                 .keys = {{.name = "of",
                                           .type = ValueType::point,
                                           .sentence = "The point whose displacement has the values."},
                                          {.name = "displacement",
                                           .type = ValueType::choice,
                                           .presence = Presence::required,
                                           .sentence = "The component, in global axes.",
                                           .choices = words_of(direction_choices),
                                           .only_with = "of"},
                                          {.name = "values",
                                           .type = ValueType::numbers,
                                           .dimension = "length",
                                           .presence = Presence::required,
                                           .sentence = "Of the displacement.",
                                           .only_with = "of"},
                                          {.name = "t",
                                           .type = ValueType::numbers,
                                           .dimension = "1",
                                           .sentence = "Values of the load factor, instead."}},
                                 .groups = {{.rule = GroupRule::exactly_one, .keys = {"of", "t"}}}};
    return table;
}

const TableSpec& control_table() {
    static const TableSpec table{
        .path = "analysis.control",
        .heading = "control = { … }",
        .sentence = "",
        .keys = {{.name = "of",
                  .type = ValueType::point,
                  .presence = Presence::required,
                  .sentence = "The point that moves."},
                 {.name = "displacement",
                  .type = ValueType::choice,
                  .default_text = "`rotation`",
                  .sentence = "Its component that each step prescribes, in global axes.",
                  .choices = words_of(direction_choices)},
                 {.name = "rotation",
                  .type = ValueType::choice,
                  .default_text = "`displacement`",
                  .sentence = "Instead, the component of the rotation in the step.",
                  .choices = words_of(direction_choices)},
                 {.name = "to",
                  .type = ValueType::number,
                  .dimension = "length",
                  .sentence =
                      "The displacement at which the path ends; it sets out to there, whether t grows "
                      "or falls.",
                  .only_with = "displacement"}},
        .groups = {{.rule = GroupRule::exactly_one, .keys = {"displacement", "rotation"}}}};
    return table;
}

// Arc lengths.
std::vector<KeySpec> step_keys(const Condition& path_only) {
    const PathSettings defaults;
    return {
        {.name = "step",
         .type = ValueType::number,
         .dimension = "1",
         .range = positive,
         .default_text = "by how the model answers to its loads",
         .sentence = "The first arc length: about the mean displacement over the model's length, or the mean "
                     "rotation in rad times 0.2. Later steps are longer or shorter as Newton's method "
                     "needs few or many iterations.",
         .only_for = {path_only}},
        {.name = "max_step",
         .type = ValueType::number,
         .dimension = "1",
         .range = positive,
         .default_value = defaults.max_step,
         .sentence = "No step is longer: long ones can pass over a branch or get on to another one.",
         .only_for = {path_only}},
        {.name = "min_step",
         .type = ValueType::number,
         .dimension = "1",
         .range = positive,
         .default_value = defaults.min_step,
         .sentence = "A path that needs a shorter step fails.",
         .only_for = {path_only}}};
}

}  // namespace

std::vector<KeySpec> path_keys() {
    const Condition path_only{"kind", {"path"}};
    const PathSettings defaults;
    std::vector<KeySpec> keys{
        {.name = "until",
         .type = ValueType::table,
         .presence = Presence::required,
         .sentence = "Where the path ends, and each of its branches: whichever comes first.",
         .only_for = {path_only},
         .table = &until_table()},
        {.name = "at",
         .type = ValueType::table_list,
         .sentence = "Displacements and load factors at which the path has an equilibrium, exactly, with a "
                     "frame, as often as it passes them.",
         .only_for = {path_only},
         .table = &at_table()},
        {.name = "control",
         .type = ValueType::table,
         .sentence =
             "Steps prescribe a displacement instead of the arc length. The path fails where that turns "
             "back.",
         .only_for = {path_only},
         .table = &control_table()},
        {.name = "critical",
         .type = ValueType::choice,
         .default_value = word_of(critical_search_choices, defaults.critical),
         .sentence = "locate: steps end on limit points and bifurcations, and their shapes are found. "
                     "report: the steps within which they lie are named. off: they are ignored.",
         .choices = words_of(critical_search_choices),
         .only_for = {path_only}},
        {.name = "branches",
         .type = ValueType::integer,
         .range = {.lower = 0, .upper = 100},
         .default_value = static_cast<long>(defaults.branches),
         .sentence = "0: the main path only. 1: also the branches that leave it at simple bifurcations, to "
                     "both sides. 2: also those that leave these, and so on. Needs critical `locate`.",
         .only_for = {path_only}},
        {.name = "follow",
         .type = ValueType::choice,
         .default_text = "no limit points",
         .sentence =
             "limit: the stage before, a path, ended on a limit point, whose load factor is free in this "
             "stage: the limit point is followed while t, the parameter, grows from 0.",
         .choices = {"limit"},
         .only_for = {path_only}}};
    const std::vector<KeySpec> steps = step_keys(path_only);
    keys.insert(keys.begin() + 1, steps.begin(), steps.end());
    return keys;
}

}  // namespace gxrod
