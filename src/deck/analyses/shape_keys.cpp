#include <fmt/format.h>

#include "deck/analyses/analysis_table.hpp"
#include "deck/analyses/listed_numbers.hpp"

// The keys of analyses that find shapes.
namespace gxrod {
namespace {

const TableSpec& sweep_table() {
    using T = SweepTable;
    static const TableSpec table = [] {
        Table<T> sweep("analysis.sweep", "");
        sweep.key("key", &T::key, "Whose value is swept, as --set names it: parameters.Omega.").required();
        return add_numbers(sweep, "1")
            .key(
                "onset",
                &T::onset,
                "locate: values between those of the sweep, at which motions begin to grow or cease to. off: "
                "only the modes at each value.")
            .key("shapes",
                 &T::shapes,
                 "Keep the shapes of the modes at each value, in NAME.STAGE.vtkhdf: six numbers or, if "
                 "they are complex, twelve for each node, mode and value.")
            .otherwise("false");
    }();
    return table;
}

}  // namespace

void add_shape_keys(Table<AnalysisTable>& table) {
    using T = AnalysisTable;
    // clang-format off
    table
        .key("count", &T::count,
             "How many: the lowest frequencies, the smallest positive factors, the eigenvalues nearest to 0.")
            .between(1, 10'000)
            .otherwise(fmt::format("`{}` modes or eigenvalues, `{}` buckling factors",
                                   ModesSettings{}.count, BucklingSettings{}.count))
            .only_for({{"kind", {"modes", "buckling", "eigenvalues"}}})
        .key("below", &T::below, "All modes of a lower frequency, in cycles per time, instead of `count`.")
            .unit("1/time").above(0).only_for({{"kind", {"modes"}}})
        .key("linearization", &T::linearization,
             "Of what is about to yield or to slip. elastic: as if it unloaded. loading: as if the load that brought "
             "it there went on, for the least factor of a plastic column.")
            .only_for({{"kind", {"modes", "buckling"}}})
        .key("sweep", &T::sweep, sweep_table(),
             "The same at each of several values of a number of the deck: the equilibrium to which the static and "
             "steady stages before lead, and its modes, each followed from value to value.")
            .only_for({{"kind", {"eigenvalues"}}});
    // clang-format on
}

}  // namespace gxrod
