
#include "deck/decks.hpp"

#include "tools/catch.hpp"

namespace gxrod::test {

TEST_CASE("Names that expressions could not use are errors", "[deck]") {
    CHECK(faults_of(body_deck + R"([parameters]
t = 1)") == "x.toml:9:1: parameters.t: t is time in expressions; choose another name");
    CHECK(faults_of(body_deck + R"([parameters]
pi = 3)") == "x.toml:9:1: parameters.pi: pi is 3.14159… in expressions; choose another name");
    CHECK(faults_of(body_deck + R"([parameters]
sin = 3)") == "x.toml:9:1: parameters.sin: sin is a built-in function; choose another name");
    CHECK(faults_of(body_deck + R"([parameters]
my-mass = 3)") ==
          "x.toml:9:1: parameters.my-mass: expressions could not use this name: write letters, digits and _, "
          "no digit first");
    CHECK(faults_of(body_deck + R"([parameters]
f = 1
[function.f]
expression = "t")") == "x.toml:10:11: function.f: a parameter has this name too; choose another one");
}

TEST_CASE("Parameters that depend on each other in a circle are an error that names it", "[deck]") {
    CHECK(faults_of(body_deck + R"([parameters]
a = "b"
b = "c + 1"
c = "a")") == "x.toml:9:5: parameters.a: the value depends on itself: a → b → c → a");
    CHECK(faults_of(body_deck + R"([parameters]
a = "a")") == "x.toml:9:5: parameters.a: the value depends on itself: a → a");
    CHECK(faults_of(body_deck + R"([parameters]
x = "a"
a = "b"
b = "a")") == "x.toml:10:5: parameters.a: the value depends on itself: a → b → a");
}

TEST_CASE("A wrong parameter is reported once", "[deck]") {
    CHECK(faults_of(body_deck + R"([parameters]
a = true)") == "x.toml:9:5: parameters.a: expected a number or an expression, found a boolean");
    CHECK(faults_of(body_deck + R"([parameters]
a = "1/0"
[[load]]
at = "top"
force = ["a", 0, "a*t"])") == R"(x.toml:9:5: parameters.a: "1/0": the value is inf, not a finite number)");
    CHECK(faults_of(body_deck + R"([parameters]
a = "c"
b = "a + 1"
d = "b*2")") == R"(x.toml:9:5: parameters.a: "c": unknown name "c"; available: pi, a, b, d)");
}

TEST_CASE("Functions that depend on each other in a circle are an error that names it", "[deck]") {
    CHECK(faults_of(body_deck + R"x([function.f]
expression = "g(t)"
[function.g]
expression = "f(t)")x") == "x.toml:9:14: function.f.expression: the function depends on itself: f → g → f");
    CHECK(faults_of(body_deck + R"x([function.f]
expression = "f(t)")x") == "x.toml:9:14: function.f.expression: the function depends on itself: f → f");
}

TEST_CASE("A function can be an integer", "[deck]") {
    const Model model = read(body_deck + R"x([function.f]
expression = 3
[[load]]
at = "top"
force = ["f(t)*t", 0, 0])x")
                            .model;
    CHECK(model.loads.at(0).force[0](0.5) == 1.5);
}

TEST_CASE("A wrong function is reported once", "[deck]") {
    CHECK(faults_of(body_deck + R"x([function.f]
expression = "1 +"
[[load]]
at = "top"
force = ["f(t)", 0, 0])x") == R"(x.toml:9:14: function.f.expression: "1 +": the expression ends too early)");
    CHECK(faults_of(body_deck + R"x([function.f]
table = [[1, 0], [0, 1]]
[function.g]
expression = "f(2*t)"
[[load]]
at = "top"
force = ["g(t)", 0, 0])x") ==
          "x.toml:9:18: function.f.table[1]: t must increase from row to row: 0 follows 1");
}

TEST_CASE("What is wrong with an input is an error", "[deck]") {
    CHECK(faults_of(body_deck + R"([parameters]
u = 1
[input.u]
value = 2)") == "x.toml:10:8: input.u: a parameter has this name too; choose another one");
    CHECK(faults_of(body_deck + R"([function.u]
expression = "t"
[input.u]
value = 2)") == "x.toml:10:8: input.u: a function has this name too; choose another one");
    CHECK(faults_of(body_deck + R"([input.t]
value = 2)") == "x.toml:8:8: input.t: t is time in expressions; choose another name");
    CHECK(faults_of(body_deck + R"([input.u]
value = "2*v"
[input.v]
value = 1)") ==
          "x.toml:9:9: input.u.value: \"v\" is an input; the value of an input can have t, parameters and "
          "functions");
    CHECK(faults_of(replaced(body_deck, "mass = 1.0", "mass = \"u\"") + R"([input.u]
value = 1)") ==
          "x.toml:2:8: body.top.mass: \"u\": \"u\" is an input, which changes during a run; values that "
          "cannot have t "
          "cannot have it either");
    CHECK(faults_of(body_deck + R"([input.motor]
[[load]]
at = "top"
force = ["motr", 0, 0])") ==
          "x.toml:11:10: load[0].force[0]: \"motr\": unknown name \"motr\"; did you mean \"motor\"? "
          "available: pi, "
          "t, x, y, z, vx, vy, vz, rx, ry, rz, wx, wy, wz, motor");
}

TEST_CASE("Time does not belong in a parameter", "[deck]") {
    CHECK(faults_of(body_deck + R"([parameters]
a = "t")") == R"(x.toml:9:5: parameters.a: "t": "t" (time) is not allowed here: this value is a constant)");
    CHECK(
        faults_of(body_deck + R"x([function.f]
expression = "t"
[parameters]
a = "f(1)")x") ==
        R"x(x.toml:11:5: parameters.a: "f(1)": "f" is a function of time, which is not allowed here: this value is a constant)x");
}

}  // namespace gxrod::test
