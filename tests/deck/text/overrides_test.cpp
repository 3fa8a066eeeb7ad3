
#include "deck/decks.hpp"
#include "deck/schema/choices.hpp"
#include "deck/schema/suggestion.hpp"
#include "tools/catch.hpp"

namespace gxrod::test {

TEST_CASE("Keys of --set that lead nowhere are errors", "[deck]") {
    CHECK(faults_of(rod_deck, {"x"}) == "--set x: expected KEY=VALUE");
    CHECK(faults_of(rod_deck, {"=3"}) ==
          "--set =3: not a key; expected one such as analysis.beta or load[0].force");
    CHECK(faults_of(rod_deck, {"analysis..beta=3"}) ==
          "--set analysis..beta=3: not a key; expected one such as analysis.beta or load[0].force");
    CHECK(faults_of(rod_deck, {"a[=3"}) ==
          "--set a[=3: not a key; expected one such as analysis.beta or load[0].force");
    CHECK(faults_of(rod_deck, {"load[0].force=[1,2,3]"}) ==
          "--set load[0].force=[1,2,3]: load: the deck has none");
    CHECK(faults_of(rod_deck, {"analisys.beta=0.3"}) ==
          R"(--set analisys.beta=0.3: analisys: the deck has none; did you mean "analysis"?)");
    CHECK(faults_of(rod_deck, {"rod.q.elements=3"}) ==
          "--set rod.q.elements=3: rod.q: the deck has none; known here: r");
    CHECK(faults_of(rod_deck, {"rod.r.line.to[3]=1"}) ==
          "--set rod.r.line.to[3]=1: no such element; valid are 0 to 2");
    CHECK(faults_of(replaced(rod_deck, "to = [10, 0, 0]", "to = []"), {"rod.r.line.to[0]=1"}) ==
          "x.toml:6:33: rod.r.line.to: expected an array of 3 numbers or expressions, found an empty array\n"
          "--set rod.r.line.to[0]=1: no such element; it is empty");
    CHECK(faults_of(rod_deck, {"rod.r.section.x=5"}) ==
          "--set rod.r.section.x=5: rod.r.section: not a table, so that it has no key x");
    CHECK(faults_of(rod_deck, {"title[0]=5"}) == "--set title[0]=5: title: the deck has none");
    CHECK(faults_of(rod_deck + R"([[load]]
at = "r.end"
force = [0, 0, 1]
[[load]]
at = "r.end"
force = [0, 0, 1])",
                    {"load[3].force=[1,2,3]"}) ==
          "--set load[3].force=[1,2,3]: load[3]: no such element; valid are 0 to 1");
    CHECK(faults_of(rod_deck + R"([[load]]
at = "r.end"
force = [0, 0, 1])",
                    {"load.at=r.start"}) ==
          "--set load.at=r.start: load: not a table, so that it has no key at; write load[0].at for the "
          "first of a list");
}

TEST_CASE("Values of --set are checked as those of a deck", "[deck]") {
    CHECK(faults_of(rod_deck, {"rod.r.elements=0"}) ==
          "--set rod.r.elements=0: expected an integer from 1 to 10000000, found 0");
    CHECK(faults_of(rod_deck, {"integrator=sdirk-4"}) ==
          R"(--set integrator=sdirk-4: unknown key; did you mean "analysis.integrator"?)");
    CHECK(faults_of(rod_deck, {"analysis.integrator=sdirk4"}) ==
          "--set analysis.integrator=sdirk4: expected one of " + quoted_list(words_of(scheme_choices)) +
              R"(, found the text "sdirk4"; did you mean "sdirk-4"?)");
    CHECK(faults_of(rod_deck, {"analysis.betta=0.3"}) ==
          R"(--set analysis.betta=0.3: unknown key; did you mean "beta"?)");
    CHECK(faults_of(rod_deck, {"rod.r.line.to[2]=up"}) ==
          R"(--set rod.r.line.to[2]=up: "up": unknown name "up"; available: pi)");
    CHECK(faults_of(rod_deck, {"rod.r.line.to=[1, .5, 2]"}) ==
          "--set rod.r.line.to=[1, .5, 2]: TOML does not read .5, a number with no digit next to its point: "
          "write 0.5");
    CHECK(faults_of(rod_deck, {"rod.r.line.to=5"}) ==
          "--set rod.r.line.to=5: expected an array of 3 numbers or expressions, found 5");
    CHECK(faults_of(rod_deck, {"rod.r.line={from=[0,0,0]}"}) ==
          "--set rod.r.line={from=[0,0,0]}: rod.r.line.to: missing; expected an array of 3 numbers or "
          "expressions");
    CHECK(faults_of(rod_deck, {"rod.r.elements=0", "analysis.steps=0"}) ==
          R"(--set rod.r.elements=0: expected an integer from 1 to 10000000, found 0
--set analysis.steps=0: expected an integer from 1 to 1000000000000, found 0)");
    CHECK(faults_of(rod_deck, {"rod.r.line.to=[10,true,0]"}) ==
          "--set rod.r.line.to=[10,true,0]: rod.r.line.to[1]: expected a number or an expression, found a "
          "boolean");
    CHECK(
        faults_of(rod_deck, {"analysis.steps=true", "rod.r.colour=red"}) ==
        R"(--set analysis.steps=true: expected an integer from 1 to 1000000000000 or an expression, found a boolean
--set rod.r.colour=red: unknown key; known here: section, sections, line, arc, helix, polyline, spline, catenary, mesh, elements, spacing, order, element, y_axis, z_axis, twist, rest, hinges, copies)");
    CHECK(faults_of(replaced(rod_deck, "steps = 10", "steps = 0"), {"rod.r.elements=0"}) ==
          R"(x.toml:12:9: analysis.steps: expected an integer from 1 to 1000000000000, found 0
--set rod.r.elements=0: expected an integer from 1 to 10000000, found 0)");
    CHECK(
        faults_of(replaced(body_deck, R"("dynamic")", R"("dynamc")"),
                  {"body.top.mass=-1", "body.top.inertia=[1,2"}) ==
        R"(x.toml:5:8: analysis.kind: expected one of "dynamic", "static", "quasi-static", "path", "steady", "modes", "buckling", "eigenvalues", "response", found the text "dynamc"; did you mean "dynamic"?
--set body.top.mass=-1: expected a number greater than 0, found -1
--set body.top.inertia=[1,2: not TOML: encountered end-of-file)");
}

TEST_CASE("Option --set takes TOML values, and text without quotes", "[deck]") {
    const Problem problem = read(body_deck,
                                 {"analysis.integrator=generalized-alpha",
                                  "analysis.spectral_radius=.5",
                                  "title=A title = \"quoted\" # and more",
                                  "body.top.inertia=[1, 2, \"1 + 1.5\"]",
                                  "body.top.mass=2*3",
                                  "units=",
                                  "analysis.end_time=2"});
    CHECK(dynamic_of(problem).scheme == Scheme::generalized_alpha);
    CHECK(dynamic_of(problem).spectral_radius == 0.5);
    CHECK(problem.record.title == "A title = \"quoted\" # and more");
    CHECK(problem.model.bodies[0].inertia == Mat3(Vec3(1, 2, 2.5).asDiagonal()));
    CHECK(problem.model.bodies[0].mass == 6.0);
    CHECK(problem.record.units.empty());
    CHECK(dynamic_of(problem).end_time == 2.0);
}

TEST_CASE("Option --set reaches into arrays, and the last value of a key counts", "[deck]") {
    const std::string deck =
        rod_deck +
        "[[load]]\nat = \"r.end\"\nforce = [1, 2, 3]\n[[load]]\nat = \"r.end\"\nforce = [4, 5, 6]\n";
    const Problem problem = read(deck,
                                 {"load[1].force[2]=60*t",
                                  "load[0].force=[7, 8, 9]",
                                  "load[0].at=r.start",
                                  "rod.r.line.to[0]=4",
                                  "rod.r.line.to[0]=5",
                                  "rod.\"r\".elements=2"});
    CHECK(problem.model.loads[1].force[1](0.0) == 5.0);
    CHECK(problem.model.loads[1].force[2](2.0) == 120.0);
    CHECK(problem.model.loads[0].force[2](0.0) == 9.0);
    CHECK(problem.model.loads[0].node == 0);
    CHECK(problem.model.nodes.size() == 3);
    CHECK(problem.model.nodes[2].position == Vec3(5, 0, 0));
}

TEST_CASE("Option --set adds keys, and tables that a deck has once", "[deck]") {
    const Problem problem = read(body_deck,
                                 {"analysis.newton.tolerance=1e-5",
                                  "analysis.newton.max_iterations=9",
                                  "output.every=3",
                                  "parameters.m=7",
                                  "body.top.mass=m",
                                  "gravity=[0, 0, -1]"});
    CHECK(dynamic_of(problem).newton.tolerance == 1e-5);
    CHECK(dynamic_of(problem).newton.max_iterations == 9);
    CHECK(problem.output.every == 3);
    CHECK(problem.model.bodies[0].mass == 7.0);
    CHECK(problem.model.gravity(0.0) == Vec3(0, 0, -1));
}

TEST_CASE("Option --set takes the place of a key that excludes the new one", "[deck]") {
    CHECK(dynamic_of(read(body_deck, {"analysis.time_step=0.25"})).steps == 4);
    const std::string spinning =
        replaced(body_deck, "mass = 1.0", "mass = 1.0\nangular_velocity = [1, 0, 0]");
    const Problem problem = read(spinning, {"body.top.angular_velocity_material=[0, 2, 0]"});
    CHECK(problem.model.nodes[0].angular_velocity == Vec3(0, 2, 0));
    CHECK(faults_of(body_deck, {"analysis.time_step=0.25", "analysis.steps=4"}) ==
          "--set analysis.steps=4: time_step is given too; only one of them can be");
    CHECK(faults_of(body_deck, {"analysis.steps=4", "analysis.time_step=0.25"}) ==
          "--set analysis.steps=4: time_step is given too; only one of them can be");
}

TEST_CASE("The deck as run names its overrides", "[deck]") {
    const Problem problem = read(body_deck, {"title=two\nlines", "output.every=3"});
    CHECK(problem.record.text.starts_with("# x.toml, run with --set title=two lines --set output.every=3\n"));
    CHECK(problem.record.title == "two\nlines");
    CHECK(read(problem.record.text).record.title == "two\nlines");
    CHECK(faults_of(body_deck, {"title=a\xFFz"}) == "--set title=a\\xffz: not UTF-8 text");
}

}  // namespace gxrod::test
