#pragma once

#include <limits>
#include <vector>

#include "deck/analyses/analysis_table.hpp"
#include "deck/places/build_context.hpp"
#include "deck/table/table.hpp"

// Numbers of a table that gives their ends or lists them.
namespace gxrod {

// Adds the keys of a NumbersTable.
template <class T>
Table<T>& add_numbers(Table<T>& table,
                      const char* unit,
                      double least = -std::numeric_limits<double>::infinity()) {
    // clang-format off
    return table
        .key("from", &T::from, "The first.")
            .unit(unit).at_least(least)
        .key("to", &T::to, "The last.")
            .unit(unit).at_least(least).required().only_with("from")
        .key("count", &T::count, "How many.")
            .between(2, 1'000'000).only_with("from")
        .key("spacing", &T::spacing, "linear: equal steps; log: equal ratios.")
            .only_with("from")
        .key("values", &T::values, "Instead: these.")
            .unit(unit)
        .exactly_one_of({"from", "values"});
    // clang-format on
}

std::vector<double> list_numbers(const NumbersTable& table, const BuildContext& context);

}  // namespace gxrod
