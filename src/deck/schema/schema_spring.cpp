#include "deck/schema/schema_tables.hpp"

namespace gxrod {

const TableSpec& spring_table() {
    constexpr Range not_negative{.lower = 0.0};
    static const TableSpec table{
        .path = "spring.NAME",
        .heading = "[spring.NAME]",
        .sentence =
            "A spring and a damper along the line between two points, A and B. Their force is stiffness "
            "times "
            "(length now - length) plus damping times the rate of the length, tension positive.",
        .keys = {{.name = "between",
                  .type = ValueType::ends,
                  .presence = Presence::required,
                  .sentence = "What carries A and B: points of rods, bodies, or \"ground\" for one that does "
                              "not move."},
                 {.name = "at_a",
                  .type = ValueType::vector,
                  .dimension = "length",
                  .default_text = "where its node is; of the ground required",
                  .sentence = "Where A is at t = 0, global. A rigid arm joins it to its node."},
                 {.name = "at_b",
                  .type = ValueType::vector,
                  .dimension = "length",
                  .default_text = "where its node is; of the ground required",
                  .sentence = "Where B is at t = 0, likewise."},
                 {.name = "stiffness",
                  .type = ValueType::number,
                  .dimension = "force/length",
                  .range = not_negative,
                  .default_value = 0.0,
                  .sentence = "Force per elongation."},
                 {.name = "damping",
                  .type = ValueType::number,
                  .dimension = "force·time/length",
                  .range = not_negative,
                  .default_value = 0.0,
                  .sentence = "Force per rate of elongation."},
                 {.name = "length",
                  .type = ValueType::number,
                  .dimension = "length",
                  .range = not_negative,
                  .default_text = "as it is at t = 0",
                  .sentence = "At which the spring pulls and pushes nothing; 0 for one that always pulls."}},
        .groups = {{GroupRule::at_least_one, {"stiffness", "damping"}}},
        .example =
            "[spring.strut]\n"
            "between   = [\"flyer.start\", \"gyroscope\"]\n"
            "at_b      = [0, 0, 1]\n"
            "stiffness = 500.0\n"
            "damping   = 2.0\n"
            "length    = 0.3\n"};
    return table;
}

}  // namespace gxrod
