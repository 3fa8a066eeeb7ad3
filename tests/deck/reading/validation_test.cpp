
#include "deck/decks.hpp"
#include "deck/schema/choices.hpp"
#include "deck/schema/suggestion.hpp"
#include "tools/catch.hpp"
#include "watch/quantities.hpp"

namespace gxrod::test {

TEST_CASE("Unknown keys are errors that name the nearest known one", "[deck]") {
    CHECK(faults_of(replaced(body_deck, "mass", "mas")) ==
          R"(x.toml:2:1: body.top.mas: unknown key; did you mean "mass"?)");
    CHECK(faults_of(replaced(body_deck, "mass = 1.0", R"(mass = 1.0
colour = 3)")) ==
          "x.toml:3:1: body.top.colour: unknown key; known here: mass, inertia, at, centre_of_mass, "
          "rotation_vector, velocity, angular_velocity, angular_velocity_material, sphere, capsule, fluid, "
          "looks, copies");
    CHECK(faults_of(rod_deck + "[zone.a]") ==
          "x.toml:13:2: zone: unknown key; known here: title, units, gravity, plane, apply, parameters, "
          "function, "
          "input, signal, "
          "section, material, layup, rod, body, spring, bushing, joint, gear, connect, imperfection, load, "
          "combination, tendon, "
          "chamber, actuation, magnetic, "
          "fluid, wave, vessel, air, seabed, contact, obstacle, support, initial, rotation, "
          "analysis, "
          "stage, output, history");
    CHECK(faults_of(body_deck + "gravity = [0, 0, -9.81]") ==
          "x.toml:8:1: analysis.gravity: kind \"dynamic\" does not use this key; it is for response; as a "
          "key of "
          "the top level it must come before the first [table]");
    CHECK(faults_of(replaced(body_deck, "mass = 1.0", R"(mass = 1.0
title = "late")")) ==
          "x.toml:3:1: body.top.title: title is a key of the top level and must come before the first "
          "[table]; here it belongs to [body.NAME]");
    CHECK(faults_of(body_deck + R"([parameters]
gravity = [0, 0, -9.81])") ==
          "x.toml:9:1: parameters.gravity: gravity is a key of the top level and must come before the first "
          "[table]; here it belongs to [parameters]");
    CHECK(faults_of(body_deck + R"([parameters]
title = "late")") ==
          "x.toml:9:1: parameters.title: title is a key of the top level and must come before the first "
          "[table]; here it belongs to [parameters]");
    CHECK(faults_of(replaced(rod_deck, "GJ = 500", "Gj = 500")) ==
          R"(x.toml:2:47: section.s.stiffness.Gj: unknown key; did you mean "GJ"?)");
    CHECK(faults_of("integrator = \"sdirk-4\"\n" + rod_deck) ==
          R"(x.toml:1:1: integrator: unknown key; did you mean "analysis.integrator"?)");
}

TEST_CASE("Errors on missing keys say what is expected", "[deck]") {
    CHECK(faults_of(replaced(body_deck, "mass = 1.0\n", "")) ==
          "x.toml:1:1: body.top.mass: missing; expected a number greater than 0 or an expression");
    CHECK(faults_of(replaced(rod_deck, "section = \"s\"\n", "")) ==
          "x.toml:4:1: rod.r: missing; expected section or sections");
    CHECK(faults_of(replaced(rod_deck, "elements = 10\n", "")) ==
          "x.toml:4:1: rod.r.elements: missing; expected an integer from 1 to 10000000");
    CHECK(faults_of(replaced(rod_deck, "rhoIy = 10, ", "")) ==
          "x.toml:3:11: section.s.inertia.rhoIy: missing; expected a number greater than 0 or an expression "
          "in s; "
          "a rotation without inertia cannot be integrated in time");
    CHECK(
        faults_of(replaced(body_deck, "kind = \"dynamic\"\n", "")) ==
        R"(x.toml:4:1: analysis.kind: missing; expected one of "dynamic", "static", "quasi-static", "path", "steady", "modes", "buckling", "eigenvalues", "response")");
    CHECK(faults_of(replaced(body_deck, "end_time = 1.0\n", "")) ==
          "x.toml:4:1: analysis.end_time: missing; expected a number greater than 0 or an expression");
    CHECK(faults_of(replaced(body_deck, "steps = 10\n", "")) ==
          "x.toml:4:1: analysis: missing; expected time_step or steps or accuracy");
    CHECK(faults_of(R"([body.top]
mass = 1.0
inertia = [1, 1, 1]
)") == "x.toml:1:1: missing; expected [analysis] or [[stage]]");
    CHECK(faults_of(R"([analysis]
kind = "dynamic"
end_time = 1.0
steps = 10
)") == "x.toml:1:1: missing; expected [rod.NAME] or [body.NAME]");
    CHECK(faults_of(body_deck + R"([[load]]
at = "top")") == "x.toml:8:1: load[0]: missing; expected force or moment");
    CHECK(faults_of(body_deck + R"([[load]]
force = [0, 0, 1])") == "x.toml:8:1: load[0]: missing; expected at or on or where");
    CHECK(faults_of(rod_deck + R"([[load]]
on = "r")") == "x.toml:13:1: load[0]: missing; expected force_per_length or moment_per_length or file");
    CHECK(faults_of(body_deck + "[function.f]") ==
          "x.toml:8:1: function.f: missing; expected table or file or expression");
    CHECK(faults_of(body_deck + "[[history]]") ==
          R"(x.toml:8:1: history[0].name: missing; expected text
x.toml:8:1: history[0].at: missing; expected a point, such as "rod.end", "rod@0.25" or "body", with * for any letters, or an array of points
x.toml:8:1: history[0].quantities: missing; expected one or a list of )" +
              quoted_list(list_quantity_words()));
    CHECK(faults_of(body_deck + "[[support]]") ==
          R"(x.toml:8:1: support[0]: missing; expected at or where
x.toml:8:1: support[0]: missing; expected fix or move = { … } or stiffness = { … } or damping = { … } or vessel)");
}

TEST_CASE("Keys that exclude each other are not given together", "[deck]") {
    CHECK(faults_of(body_deck + "time_step = 0.1") ==
          "x.toml:7:1: analysis.steps: time_step is given too; only one of them can be");
    CHECK(faults_of(replaced(body_deck, "mass = 1.0", R"(mass = 1.0
angular_velocity = [0, 0, 1]
angular_velocity_material = [0, 0, 1])")) ==
          "x.toml:4:1: body.top.angular_velocity_material: angular_velocity is given too; only one of them "
          "can be");
    CHECK(faults_of(body_deck + R"([function.f]
table = [[0, 1]]
expression = "t")") == "x.toml:10:1: function.f.expression: table is given too; only one of them can be");
}

TEST_CASE("Tables have the form that the schema gives them", "[deck]") {
    CHECK(faults_of(R"(rod = 3
body = [1]
load = { at = "x" }
parameters = "x"
analysis = 1
)") ==
          R"(x.toml:1:7: rod: expected a table [rod.NAME], found 3
x.toml:2:8: body: expected a table [body.NAME], found an array of 1
x.toml:3:8: load: expected tables [[load]], found a table
x.toml:4:14: parameters: expected a table [parameters], found the text "x"
x.toml:5:12: analysis: expected a table [analysis], found 1)");
    CHECK(faults_of(R"(title = 1
units = ["m"]
gravity = "down"
load = [1]
[rod]
section = "s"
[analysis]
kind = "dynamic"
end_time = 1.0
steps = 10
)") ==
          R"(x.toml:1:9: title: expected text, found 1
x.toml:2:9: units: expected text, found an array of 1
x.toml:3:11: gravity: expected an array of 3 numbers or expressions in t, found the text "down"
x.toml:4:9: load[0]: expected tables [[load]], found 1
x.toml:6:11: rod.section: expected a table [rod.NAME], found the text "s")");
    CHECK(faults_of(replaced(body_deck, "steps = 10", R"(steps = 10
newton = 3)")) == "x.toml:8:10: analysis.newton: expected a table newton = { … }, found 3");
    CHECK(faults_of(replaced(rod_deck, "line = { from = [0, 0, 0], to = [10, 0, 0] }", "line = [0, 0, 0]")) ==
          "x.toml:6:8: rod.r.line: expected a table line = { … }, found an array of 3");
    CHECK(faults_of(rod_deck + "[[output]]") ==
          "x.toml:13:1: output: expected a table [output], found an array of 1");
    CHECK(faults_of(rod_deck + R"([support]
at = "r.end")") == "x.toml:13:1: support: expected tables [[support]], found a table");
    CHECK(faults_of(rod_deck + "[[load.extra]]") ==
          "x.toml:13:1: load: expected tables [[load]], found a table");
}

TEST_CASE("Names have the letters that points and expressions can use", "[deck]") {
    CHECK(faults_of(replaced(body_deck, "[body.top]", R"([body."my top"])")) ==
          "x.toml:1:7: body.my top: a name has letters, digits, _ and - only");
    CHECK(faults_of(body_deck + R"([function.2f]
expression = "t")") ==
          "x.toml:8:11: function.2f: expressions could not use this name: write letters, digits and _, no "
          "digit first");
}

TEST_CASE("A key that the integrator does not use is an error", "[deck]") {
    CHECK(
        faults_of(body_deck + "spectral_radius = 0.5") ==
        R"(x.toml:8:1: analysis.spectral_radius: integrator "newmark-simplified" does not use this key; it is for generalized-alpha)");
    CHECK(
        faults_of(body_deck + R"(integrator = "sdirk-4"
beta = 0.3)") ==
        R"(x.toml:9:1: analysis.beta: integrator "sdirk-4" does not use this key; it is for newmark-simplified, newmark-ibrahimbegovic)");
    CHECK(
        faults_of(body_deck + R"(integrator = "runge-kutta-4"
newton = { tolerance = 1e-3 })") ==
        R"(x.toml:9:1: analysis.newton: integrator "runge-kutta-4" does not use this key; it is for newmark-simplified, newmark-ibrahimbegovic, generalized-alpha, sdirk-4, radau-5, gauss-4, energy-momentum, auto)");
    CHECK(
        faults_of(body_deck + R"(integrator = "generalized-alpha"
gamma = 0.5)") ==
        R"(x.toml:9:1: analysis.gamma: integrator "generalized-alpha" does not use this key; it is for newmark-simplified, newmark-ibrahimbegovic)");
}

TEST_CASE("A key that the kind of analysis does not use is an error", "[deck]") {
    const std::string static_deck =
        replaced(replaced(body_deck, "end_time = 1.0\n", ""), R"("dynamic")", R"("static")");
    CHECK(faults_of(static_deck).empty());
    for (const std::string key : {"end_time = 1.0", "time_step = 0.1", "beta = 0.25", "gamma = 0.5"}) {
        CHECK(faults_of(static_deck + key) ==
              "x.toml:7:1: analysis." + key.substr(0, key.find(' ')) +
                  ": kind \"static\" does not use this key; it is for dynamic" +
                  (key.find("time") == std::string::npos ? "" : ", quasi-static"));
    }
    CHECK(faults_of(static_deck + "integrator = \"sdirk-4\"") ==
          R"(x.toml:7:1: analysis.integrator: kind "static" does not use this key; it is for dynamic)");
    CHECK(faults_of(static_deck + "newton = { tolerance = 1e-3 }").empty());
}

TEST_CASE("A key goes with the one that it belongs to", "[deck]") {
    CHECK(faults_of(rod_deck + R"([[load]]
on = "r"
force = [0, 0, 1]
force_per_length = [0, 0, 1])") ==
          "x.toml:15:9: load[0].force: goes with at, and this table has on, with which go force_per_length, "
          "moment_per_length");
    CHECK(
        faults_of(rod_deck + R"([[load]]
at = "r.end"
force = [0, 0, 1]
moment_per_length = [0, 0, 1])") ==
        "x.toml:16:21: load[0].moment_per_length: goes with on, and this table has at, with which go force, "
        "moment");
    CHECK(faults_of(rod_deck + R"([[load]]
at = "r.end"
on = "r"
force = [0, 0, 1]
moment_per_length = [0, 0, 1])") == "x.toml:15:1: load[0].on: at is given too; only one of them can be");
}

TEST_CASE("All faults of a schema come at once, in the order of the deck", "[deck]") {
    CHECK(faults_of(R"(title = 3
[rod.r]
elements = 0
section = 1
element = "simo"
line = { to = [1, 2], from = [0, true, "1/0"] }
[body.b]
mas = 1
inertia = [1, 1, -1]
[[load]]
at = "nowhere"
[analysis]
kind = "static"
end_time = -1
)") ==
          R"(x.toml:1:9: title: expected text, found 3
x.toml:3:12: rod.r.elements: expected an integer from 1 to 10000000, found 0
x.toml:4:11: rod.r.section: expected the name of a section, found 1
x.toml:6:15: rod.r.line.to: expected an array of 3 numbers or expressions, found an array of 2
x.toml:6:34: rod.r.line.from[1]: expected a number or an expression, found a boolean
x.toml:6:40: rod.r.line.from[2]: "1/0": the value is inf, not a finite number
x.toml:8:1: body.b.mas: unknown key; did you mean "mass"?
x.toml:9:11: body.b.inertia: expected principal moments that are not negative, found -1, 1, 1
x.toml:10:1: load[0]: missing; expected force or moment
x.toml:14:1: analysis.end_time: kind "static" does not use this key; it is for dynamic, quasi-static
x.toml:14:12: analysis.end_time: expected a number greater than 0, found -1)");
}

TEST_CASE("All faults beyond the schema come at once, in the order of the deck", "[deck]") {
    CHECK(faults_of(R"([[load]]
at = "nowhere"
force = [0, 0, 1]
[rod.r]
section = "none"
line = { from = [1, 2, 3], to = [1, 2, 3] }
elements = 3
element = "simo"
[[load]]
at = "r.end"
force = ["1/t", 0, 0]
[body.b]
mass = 1
inertia = [1, 1, 5]
[analysis]
kind = "dynamic"
end_time = 1
steps = 3
newton = { tangent = "paper" }
[[history]]
name = "time"
at = "b"
quantities = "strain"
)") ==
          R"(x.toml:2:6: load[0].at: no point "nowhere"; the deck has r.start, r.end, b
x.toml:5:11: rod.r.section: no section "none"; the deck has no section
x.toml:6:33: rod.r.line.to: the rod has no length; expected an end away from its start
x.toml:11:10: load[1].force[0]: "1/t" is inf at t = 0
x.toml:14:11: body.b.inertia: no body has the principal moments 1, 1, 5: the largest cannot be above the sum of the others; expected 2 at most, or greater values of the others
x.toml:19:22: analysis.newton.tangent: "paper" is for decks of bodies alone; this one has rods
x.toml:21:8: history[0].name: "time" is taken: a column of all histories has it
x.toml:23:14: history[0].quantities: "strain": only points of rods have it; this one is a body)");
}

}  // namespace gxrod::test
