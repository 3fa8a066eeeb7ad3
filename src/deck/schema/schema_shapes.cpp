#include <fmt/format.h>

#include "deck/schema/choices.hpp"
#include "deck/schema/schema_tables.hpp"
#include "model/settings/settings.hpp"

// The keys of analyses that find shapes.
namespace gxrod {
namespace {

const TableSpec& sweep_table() {
    static const TableSpec table = [] {
        TableSpec sweep{.path = "analysis.sweep",
                        .heading = "sweep = { … }",
                        .sentence = "",
                        .keys = {{.name = "key",
                                  .type = ValueType::text,
                                  .presence = Presence::required,
                                  .sentence = "Whose value is swept, as --set names it: parameters.Omega."}},
                        .groups = {value_group()}};
        for (KeySpec& key : value_keys("1", {}, 21)) sweep.keys.push_back(std::move(key));
        sweep.keys.push_back({.name = "onset",
                              .type = ValueType::choice,
                              .default_value = std::string("locate"),
                              .sentence =
                                  "locate: values between those of the sweep, at which motions begin to "
                                  "grow or cease to. off: only the modes at each value.",
                              .choices = {"locate", "off"}});
        return sweep;
    }();
    return table;
}

}  // namespace

std::vector<KeySpec> shape_keys() {
    const Condition with_shapes{"kind", {"modes", "buckling", "eigenvalues"}};
    const Condition modes_only{"kind", {"modes"}};
    return {
        {.name = "count",
         .type = ValueType::integer,
         .range = {.lower = 1, .upper = 10'000},
         .default_text = fmt::format("`{}` modes or eigenvalues, `{}` buckling factors",
                                     ModesSettings{}.count,
                                     BucklingSettings{}.count),
         .sentence = "How many: the lowest frequencies, the smallest positive factors, the eigenvalues "
                     "nearest to 0.",
         .only_for = {with_shapes}},
        {.name = "below",
         .type = ValueType::number,
         .dimension = "1/time",
         .range = positive,
         .sentence = "All modes of a lower frequency, in cycles per time, instead of `count`.",
         .only_for = {modes_only}},
        {.name = "linearization",
         .type = ValueType::choice,
         .default_value = word_of(linearization_choices, ModesSettings{}.linearization),
         .sentence =
             "Of what is about to yield or to slip. elastic: as if it unloaded. loading: as if the load "
             "that brought it there went on, for the least factor of a plastic column.",
         .choices = words_of(linearization_choices),
         .only_for = {{"kind", {"modes", "buckling"}}}},
        {.name = "sweep",
         .type = ValueType::table,
         .sentence = "The same at each of several values of a number of the deck: the equilibrium to which "
                     "the static and steady stages before lead, and its modes, each followed from value to "
                     "value.",
         .only_for = {{"kind", {"eigenvalues"}}},
         .table = &sweep_table()}};
}

}  // namespace gxrod
