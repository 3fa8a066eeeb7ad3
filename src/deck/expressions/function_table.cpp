#include "deck/expressions/function_table.hpp"

#include "deck/schema/schema_tables.hpp"
#include "deck/table/table.hpp"

namespace gxrod {

const TableSpec& function_table() {
    using T = FunctionTable;
    // clang-format off
    static const TableSpec table = Table<T>("[function.NAME]",
            "A function of one variable that values given as f(t) can call, as in \"0.5*pulse(t)\".")
        .key("table", &T::table, "Rows [t, value] with t increasing; the first and the last value are held outside.")
            .also("data values")
        .key("file", &T::file, "A CSV file with the rows, found from the deck's folder and kept in the results. A "
             "first row that is not all numbers is its header; rows that begin with # are left out.")
        .key("columns", &T::columns, "The columns of t and of the value, by their names in the header or by their "
             "numbers from 1.")
            .otherwise("[1, 2]").only_with("file")
        .key("expression", &T::expression, "The value in terms of t; may call other functions.")
            .also("expr formula f value")
        .key("interpolation", &T::interpolation, "Between the rows. linear: straight lines. cubic: the spline whose "
             "curvature is continuous, for motions (not-a-knot at its ends). monotone: cubics whose slope is "
             "continuous and that rise and fall only where the rows do.")
            .otherwise("`\"linear\"`")
        .exactly_one_of({"table", "file", "expression"})
        .at_most_one_of({"interpolation", "expression"})
        .shown_by(
            "[function.pulse]\n"
            "table = [[0, 0], [2.5, 200], [5, 0]]\n"
            "interpolation = \"linear\"\n"
            "\n"
            "[function.push]\n"
            "expression = \"t < 2.5 ? 8*sin(pi*t/2.5)^2 : 0\"\n");
    // clang-format on
    return table;
}

}  // namespace gxrod
