#include "deck/schema/choices.hpp"
#include "deck/schema/schema_tables.hpp"

// [function.NAME], [input.NAME] and [body.NAME].
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

const TableSpec& input_table() {
    static const TableSpec table{
        .path = "input.NAME",
        .heading = "[input.NAME]",
        .sentence =
            "A number that whoever drives the run can change while it goes on: values given as f(t) read it "
            "by "
            "its name, as in \"0.1*NAME\". Results record it in /inputs.",
        .keys = {{.name = "value",
                  .type = ValueType::time_expression,
                  .default_text = "0",
                  .sentence = "What it is until it is set: a number, or f(t), so also the rows of a file, "
                              "through a function."},
                 {.name = "hold",
                  .type = ValueType::choice,
                  .default_text = "`\"step\"`",
                  .sentence = "How it goes from one value to the next. step: at once. linear: on a straight "
                              "line over the time that is advanced next.",
                  .choices = words_of(input_hold_choices)}},
        .groups = {},
        .example =
            "[input.tendon]\n"
            "value = 0\n"
            "hold = \"linear\"\n"};
    return table;
}

constexpr const char* body_example =
    "[body.gyroscope]\n"
    "mass            = 1.0\n"
    "inertia         = [1.0, 1.0, 0.75]\n"
    "at              = [0, 0, 0]\n"
    "centre_of_mass  = [0, 0, 0.5]\n"
    "rotation_vector = [0, \"pi/3\", 0]\n"
    "angular_velocity_material = [0, 0, 50]\n";

const TableSpec& body_table() {
    static const TableSpec table{
        .path = "body.NAME",
        .heading = "[body.NAME]",
        .sentence =
            "A rigid body fixed to a node. Its axes at t = 0 are the global axes turned by "
            "rotation_vector. `at`, velocities and loads refer to the node, not to the centre of mass.",
        .keys = {{.name = "mass",
                  .type = ValueType::number,
                  .dimension = "mass",
                  .range = positive,
                  .default_text = "0 if static, else required",
                  .sentence = "Mass."},
                 {.name = "inertia",
                  .type = ValueType::inertia,
                  .dimension = "mass·length²",
                  .default_text = "0 if static or at a rod's point, else required",
                  .sentence =
                      "About the centre of mass, body axes: 3 principal moments or a symmetric 3×3 matrix; "
                      "no principal moment above the sum of the others. Where the body has a node of its own "
                      "in a dynamic analysis, positive definite."},
                 {.name = "at",
                  .type = ValueType::placement,
                  .dimension = "length",
                  .default_value = Vec3(0, 0, 0),
                  .sentence = "Where its node is; or a rod's point, whose node it then shares."},
                 {.name = "centre_of_mass",
                  .type = ValueType::vector,
                  .dimension = "length",
                  .default_value = Vec3(0, 0, 0),
                  .sentence = "From the node, body axes."},
                 {.name = "rotation_vector",
                  .type = ValueType::vector,
                  .dimension = "angle",
                  .default_value = Vec3(0, 0, 0),
                  .sentence = "The attitude at t = 0."},
                 {.name = "velocity",
                  .type = ValueType::vector,
                  .dimension = "length/time",
                  .default_value = Vec3(0, 0, 0),
                  .sentence = "Of the node at t = 0, global components."},
                 {.name = "angular_velocity",
                  .type = ValueType::vector,
                  .dimension = "angle/time",
                  .default_value = Vec3(0, 0, 0),
                  .sentence = "At t = 0, global components."},
                 {.name = "angular_velocity_material",
                  .type = ValueType::vector,
                  .dimension = "angle/time",
                  .default_text = "what angular_velocity says",
                  .sentence = "At t = 0, components in the body axes."},
                 {.name = "sphere",
                  .type = ValueType::table,
                  .sentence = "With which it touches every [obstacle.NAME], and rods and other bodies if "
                              "there is [contact].",
                  .table = &body_sphere_table()},
                 {.name = "capsule",
                  .type = ValueType::table,
                  .sentence = "The same: all within a radius of a segment.",
                  .table = &body_capsule_table()},
                 {.name = "fluid",
                  .type = ValueType::table,
                  .sentence = "What [fluid] and [air] see of it. Without it they pass it by. The ground does "
                              "not touch bodies.",
                  .table = &body_fluid_table()}},
        .groups = {{GroupRule::at_most_one, {"angular_velocity", "angular_velocity_material"}},
                   {GroupRule::at_most_one, {"sphere", "capsule"}}},
        .example = body_example};
    return table;
}

}  // namespace gxrod
