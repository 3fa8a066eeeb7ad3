
#include "deck/decks.hpp"
#include "deck/expressions/expression_built_ins.hpp"
#include "deck/schema/suggestion.hpp"
#include "tools/catch.hpp"

namespace gxrod::test {

TEST_CASE("Numbers and vectors are finite, of the right type and in range", "[deck]") {
    CHECK(faults_of(replaced(body_deck, "mass = 1.0", "mass = true")) ==
          "x.toml:2:8: body.top.mass: expected a number greater than 0 or an expression, found a boolean");
    CHECK(
        faults_of(replaced(body_deck, "mass = 1.0", "mass = [1]")) ==
        "x.toml:2:8: body.top.mass: expected a number greater than 0 or an expression, found an array of 1");
    CHECK(faults_of(replaced(body_deck, "mass = 1.0", "mass = 2020-01-01")) ==
          "x.toml:2:8: body.top.mass: expected a number greater than 0 or an expression, found a date");
    CHECK(faults_of(replaced(body_deck, "mass = 1.0", "mass = { a = 1 }")) ==
          "x.toml:2:8: body.top.mass: expected a number greater than 0 or an expression, found a table");
    CHECK(faults_of(replaced(body_deck, "mass = 1.0", "mass = nan")) ==
          "x.toml:2:8: body.top.mass: expected a finite number, found nan");
    CHECK(faults_of(replaced(body_deck, "mass = 1.0", "mass = inf")) ==
          "x.toml:2:8: body.top.mass: expected a finite number, found inf");
    CHECK(faults_of(replaced(body_deck, "mass = 1.0", "mass = 0")) ==
          "x.toml:2:8: body.top.mass: expected a number greater than 0, found 0");
    CHECK(faults_of(replaced(body_deck, "mass = 1.0", "mass = -1")) ==
          "x.toml:2:8: body.top.mass: expected a number greater than 0, found -1");
    CHECK(faults_of(replaced(body_deck, "mass = 1.0", R"(mass = "2 - 3")")) ==
          R"(x.toml:2:8: body.top.mass: expected a number greater than 0, found "2 - 3" = -1)");
    CHECK(
        faults_of(replaced(body_deck, "mass = 1.0", R"(mass = 1.0
at = true)")) ==
        R"(x.toml:3:6: body.top.at: expected an array of 3 numbers or expressions, or a point such as "rod.end", found a boolean)");
    CHECK(
        faults_of(replaced(body_deck, "mass = 1.0", R"(mass = 1.0
at = [0, 0])")) ==
        R"(x.toml:3:6: body.top.at: expected an array of 3 numbers or expressions, or a point such as "rod.end", found an array of 2)");
    CHECK(faults_of(replaced(body_deck, "mass = 1.0", R"(mass = 1.0
velocity = 3)")) == "x.toml:3:12: body.top.velocity: expected an array of 3 numbers or expressions, found 3");
    CHECK(faults_of(replaced(body_deck, "[1, 1, 1]", "[1, 1]")) ==
          "x.toml:3:11: body.top.inertia: expected an array of 3 numbers or expressions, or of 3 such "
          "arrays, found an array of 2");
    CHECK(faults_of(replaced(body_deck, "[1, 1, 1]", "[]")) ==
          "x.toml:3:11: body.top.inertia: expected an array of 3 numbers or expressions, or of 3 such "
          "arrays, found an empty array");
    CHECK(faults_of(replaced(body_deck, "[1, 1, 1]", "3")) ==
          "x.toml:3:11: body.top.inertia: expected an array of 3 numbers or expressions, or of 3 such "
          "arrays, found 3");
    CHECK(faults_of(replaced(body_deck, "[1, 1, 1]", "[1, true, 1]")) ==
          "x.toml:3:15: body.top.inertia[1]: expected a number or an expression, found a boolean");
    CHECK(faults_of(replaced(body_deck, "[1, 1, 1]", "[[1, 0, 0], [0, 1, 0], [0, 1]]")) ==
          "x.toml:3:34: body.top.inertia[2]: expected an array of 3 numbers or expressions, or of 3 such "
          "arrays, found an array of 2");
    CHECK(faults_of(replaced(body_deck, "[1, 1, 1]", "[1, inf, 1]")) ==
          "x.toml:3:15: body.top.inertia[1]: expected a finite number, found inf");
}

TEST_CASE("Integers are integers in range", "[deck]") {
    CHECK(faults_of(replaced(rod_deck, "elements = 10", "elements = 10.0")) ==
          "x.toml:7:12: rod.r.elements: expected an integer from 1 to 10000000, found 10.0");
    CHECK(faults_of(replaced(rod_deck, "elements = 10", "elements = 0")) ==
          "x.toml:7:12: rod.r.elements: expected an integer from 1 to 10000000, found 0");
    CHECK(faults_of(replaced(rod_deck, "elements = 10", "elements = true")) ==
          "x.toml:7:12: rod.r.elements: expected an integer from 1 to 10000000 or an expression, found a "
          "boolean");
    CHECK(faults_of(replaced(rod_deck, "elements = 10", R"(elements = "5/2")")) ==
          R"(x.toml:7:12: rod.r.elements: expected an integer from 1 to 10000000, found "5/2" = 2.5)");
    CHECK(faults_of(replaced(rod_deck, "elements = 10", "elements = 20000000")) ==
          "x.toml:7:12: rod.r.elements: expected an integer from 1 to 10000000, found 20000000; 10000000 "
          "elements already need more than 30 GB of memory");
    CHECK(
        faults_of(replaced(rod_deck, "elements = 10", R"(elements = "1e9")")) ==
        R"(x.toml:7:12: rod.r.elements: expected an integer from 1 to 10000000, found "1e9" = 1000000000; 10000000 elements already need more than 30 GB of memory)");
    CHECK(faults_of(replaced(rod_deck, R"(element = "simo")", R"(element = "simo"
order = 5)")) == "x.toml:9:9: rod.r.order: expected an integer from 1 to 4, found 5");
    CHECK(faults_of(replaced(body_deck, "steps = 10", "steps = 0")) ==
          "x.toml:7:9: analysis.steps: expected an integer from 1 to 1000000000000, found 0");
    CHECK(faults_of(replaced(body_deck, "steps = 10", "steps = 1.5")) ==
          "x.toml:7:9: analysis.steps: expected an integer from 1 to 1000000000000, found 1.5");
    CHECK(faults_of(body_deck + "newton = { max_iterations = 0 }") ==
          "x.toml:8:29: analysis.newton.max_iterations: expected an integer from 1 to 1000000, found 0");
    CHECK(
        faults_of(body_deck + "newton = { max_iterations = 2000000 }") ==
        "x.toml:8:29: analysis.newton.max_iterations: expected an integer from 1 to 1000000, found 2000000");
    CHECK(faults_of(body_deck + R"([output]
every = 0)") == "x.toml:9:9: output.every: expected an integer from 1 to 1000000000000, found 0");
}

TEST_CASE("Every bound of a range is kept", "[deck]") {
    CHECK(faults_of(replaced(rod_deck, "GJ = 500", "GJ = 0")) ==
          "x.toml:2:52: section.s.stiffness.GJ: expected a number greater than 0, found 0");
    CHECK(faults_of(replaced(rod_deck, "rhoIz = 11", "rhoIz = 0")) ==
          "x.toml:3:56: section.s.inertia.rhoIz: expected a number greater than 0, found 0; a rotation "
          "without inertia cannot be integrated in time");
    CHECK(faults_of(replaced(rod_deck, "rhoA = 1.0", "rhoA = 0")) ==
          "x.toml:3:20: section.s.inertia.rhoA: expected a number greater than 0, found 0");
    CHECK(faults_of(replaced(body_deck, "end_time = 1.0", "end_time = 0.0")) ==
          "x.toml:6:12: analysis.end_time: expected a number greater than 0, found 0.0");
    CHECK(faults_of(replaced(body_deck, "steps = 10", "time_step = -0.1")) ==
          "x.toml:7:13: analysis.time_step: expected a number greater than 0, found -0.1");
    CHECK(faults_of(body_deck + "beta = 0.6") ==
          "x.toml:8:8: analysis.beta: expected a number greater than 0, at most 0.5, found 0.6");
    CHECK(faults_of(body_deck + "beta = 0") ==
          "x.toml:8:8: analysis.beta: expected a number greater than 0, at most 0.5, found 0");
    CHECK(faults_of(body_deck + "gamma = 1.5") ==
          "x.toml:8:9: analysis.gamma: expected a number from 0 to 1, found 1.5");
    CHECK(faults_of(body_deck + "gamma = -0.5") ==
          "x.toml:8:9: analysis.gamma: expected a number from 0 to 1, found -0.5");
    CHECK(faults_of(body_deck + R"(integrator = "generalized-alpha"
spectral_radius = 1.1)") ==
          "x.toml:9:19: analysis.spectral_radius: expected a number from 0 to 1, found 1.1");
    CHECK(faults_of(body_deck + "newton = { tolerance = 0 }") ==
          "x.toml:8:24: analysis.newton.tolerance: expected a number greater than 0, found 0");
}

TEST_CASE("Functions of time are numbers or expressions in t", "[deck]") {
    CHECK(faults_of(body_deck + R"([[load]]
at = "top"
force = 3)") ==
          "x.toml:10:9: load[0].force: expected an array of 3 numbers or expressions in t, x, y, z, vx, vy, "
          "vz, "
          "rx, ry, rz, wx, wy and wz, found 3");
    CHECK(faults_of(body_deck + R"([[load]]
at = "top"
force = [0, true, 0])") ==
          "x.toml:10:13: load[0].force[1]: expected a number or an expression in t, x, y, z, vx, vy, vz, rx, "
          "ry, "
          "rz, wx, wy and wz, "
          "found a boolean");
    CHECK(faults_of(body_deck + R"([[load]]
at = "top"
force = [0, 0, nan])") == "x.toml:10:16: load[0].force[2]: expected a finite number, found nan");
    CHECK(
        faults_of(body_deck + R"([[load]]
at = "top"
force = [0, "tt", 0])") ==
        R"(x.toml:10:13: load[0].force[1]: "tt": unknown name "tt"; available: pi, t, x, y, z, vx, vy, vz, rx, ry, rz, wx, wy, wz)");
    CHECK(faults_of(body_deck + R"x([function.f]
expression = "t"
[[load]]
at = "top"
force = [0, "g(t)", 0])x") ==
          R"x(x.toml:12:13: load[0].force[1]: "g(t)": unknown function "g"; available: )x" +
              plain_list(built_in_functions()) + ", f");
}

TEST_CASE("Tables of a function have rows with t increasing", "[deck]") {
    CHECK(faults_of(body_deck + R"([function.f]
table = [])") == "x.toml:9:9: function.f.table: expected an array of rows [t, value], found an empty array");
    CHECK(faults_of(body_deck + R"([function.f]
table = [[0, 1], [1]])") ==
          "x.toml:9:18: function.f.table[1]: expected a row [t, value], found an array of 1");
    CHECK(faults_of(body_deck + R"([function.f]
table = [[0, 1], [1, true]])") ==
          "x.toml:9:22: function.f.table[1][1]: expected a number or an expression, found a boolean");
    CHECK(faults_of(body_deck + R"([function.f]
table = [[0, 1], [2, 1], [2, 3]])") ==
          "x.toml:9:26: function.f.table[2]: t must increase from row to row: 2 follows 2");
    CHECK(faults_of(body_deck + R"([function.f]
expression = true)") ==
          "x.toml:9:14: function.f.expression: expected a number or an expression in t, found a boolean");
}

}  // namespace gxrod::test
