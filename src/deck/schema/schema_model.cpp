#include "deck/schema/choices.hpp"
#include "deck/schema/schema_tables.hpp"

// [function.NAME].
namespace gxrod {

const TableSpec& function_table() {
    static const TableSpec table{
        .path = "function.NAME",
        .heading = "[function.NAME]",
        .sentence = "A function of one variable that values given as f(t) can call, as in \"0.5*pulse(t)\".",
        .keys = {{.name = "table",
                  .type = ValueType::time_table,
                  .sentence =
                      "Rows [t, value] with t increasing; the first and the last value are held outside."},
                 {.name = "file",
                  .type = ValueType::text,
                  .sentence =
                      "A CSV file with the rows, found from the deck's folder and kept in the results. A "
                      "first row that is not all numbers is its header; rows that begin with # are left "
                      "out."},
                 {.name = "columns",
                  .type = ValueType::columns,
                  .default_text = "[1, 2]",
                  .sentence = "The columns of t and of the value, by their names in the header or by their "
                              "numbers from 1.",
                  .only_with = "file"},
                 {.name = "expression",
                  .type = ValueType::time_expression,
                  .sentence = "The value in terms of t; may call other functions."},
                 {.name = "interpolation",
                  .type = ValueType::choice,
                  .default_text = "`\"linear\"`",
                  .sentence =
                      "Between the rows. linear: straight lines. cubic: the spline whose curvature is "
                      "continuous, for motions (not-a-knot at its ends). monotone: cubics whose slope is "
                      "continuous and that rise and fall only where the rows do.",
                  .choices = words_of(interpolation_choices)}},
        .groups = {{GroupRule::exactly_one, {"table", "file", "expression"}},
                   {GroupRule::at_most_one, {"interpolation", "expression"}}},
        .example =
            "[function.pulse]\n"
            "table = [[0, 0], [2.5, 200], [5, 0]]\n"
            "interpolation = \"linear\"\n"
            "\n"
            "[function.push]\n"
            "expression = \"t < 2.5 ? 8*sin(pi*t/2.5)^2 : 0\"\n"};
    return table;
}

}  // namespace gxrod
