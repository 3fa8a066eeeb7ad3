
#include "analyses/dynamic.hpp"
#include "deck/decks.hpp"
#include "tools/catch.hpp"

// Motions of rods that are nearly rigid against bending or twist in one direction: Newton's method cut
// thousands of steps for them.

namespace gxrod::test {
namespace {

// A tape falls under its weight, with a little load sideways.
std::string make_tape(const std::string& section, const std::string& integrator = "generalized-alpha") {
    return "gravity = [0, 0, -9.81]\n[section.s]\n" + section + R"(
inertia = { rhoA = 0.08, rhoIy = 5e-7, rhoIz = 5e-7 }
[rod.b]
section = "s"
line = { from = [0, 0, 0], to = [1, 0, 0] }
y_axis = [0, 1, 0]
elements = 20
order = 2
[[support]]
at = "b.start"
fix = "all"
[[load]]
at = "b.end"
force = [0, 0.02, 0]
[analysis]
kind = "dynamic"
end_time = 1.0
time_step = 2e-3
integrator = ")" +
           integrator + "\"\n";
}

std::string strip_section(const std::string& EIz) {
    return "stiffness = { EA = 300.0, GAy = 100.0, GAz = 100.0, GJ = 8e-3, EIy = 4e-3, EIz = " + EIz + " }";
}

struct Fall {
    long cuts = 0;
    Vec3 end;
};

Fall run(const std::string& deck) {
    const Problem problem = read(deck);
    const DynamicSettings settings = dynamic_of(problem);
    DynamicAnalysis analysis(problem.model, settings);
    REQUIRE(analysis.start().converged());
    Fall fall;
    while (!analysis.finished()) {
        REQUIRE(analysis.advance().converged());
        fall.cuts += analysis.solver_row().rejected_steps;
    }
    fall.end = analysis.state().trial[static_cast<std::size_t>(problem.model.rods[0].nodes.back())].r;
    return fall;
}

const std::string consistent = "newton.tangent = \"consistent\"\n";

}  // namespace

TEST_CASE("A tape falls in as many steps however stiff it is in its plane", "[issues]") {
    const Fall soft = run(make_tape(strip_section("0.04")));
    CHECK(soft.cuts == 0);
    for (const char* EIz : {"40.0", "4e3", "4e4"}) {
        INFO(EIz);
        CHECK(run(make_tape(strip_section(EIz))).cuts == 0);
    }
}

TEST_CASE("A nearly rigid tape falls as with the consistent tangent and short steps", "[issues]") {
    const std::string deck = replaced(make_tape(strip_section("4e4")), "end_time = 1.0", "end_time = 0.4");
    const Fall stiff = run(deck);
    CHECK(stiff.cuts == 0);
    CHECK(run(deck + consistent).cuts > 50);
    // The step's own error is 1e-4 there.
    const std::string fine = replaced(deck, "time_step = 2e-3", "time_step = 2e-4");
    const Fall expected = run(fine + consistent);
    CHECK(expected.cuts == 0);
    CHECK((stiff.end - expected.end).norm() < 2e-4);
    CHECK((run(fine).end - expected.end).norm() < 1e-7);
}

TEST_CASE("What the consistent tangent did to the tape", "[issues]") {
    CHECK(run(make_tape(strip_section("40.0")) + consistent).cuts > 100);
}

TEST_CASE("A tape whose full matrix hides its stiff direction falls in as many steps", "[issues]") {
    // The tape, its section in axes half-way between its own.
    const std::string section = R"(stiffness_matrix = [
  [300, 0, 0, 0, 0, 0], [0, 100, 0, 0, 0, 0], [0, 0, 100, 0, 0, 0],
  [0, 0, 0, 0.008, 0, 0], [0, 0, 0, 0, 20.002, 19.998], [0, 0, 0, 0, 19.998, 20.002]])";
    const std::string deck = replaced(make_tape(section), "y_axis = [0, 1, 0]", "y_axis = [0, 1, 1]");
    CHECK(run(deck).cuts == 0);
    CHECK(run(deck + consistent).cuts > 50);
}

TEST_CASE("A flat blade spins up in as many steps with any scheme", "[issues]") {
    for (const char* integrator : {"newmark-simplified", "newmark-ibrahimbegovic", "sdirk-4"}) {
        INFO(integrator);
        const std::string deck = R"(gravity = [0, 0, -9.81]
[section.s]
stiffness = { EA = 4e5, GAy = 1.3e5, GAz = 1.3e5, GJ = 2.0, EIy = 1.0, EIz = 1e6 }
inertia = { rhoA = 0.2, rhoIy = 1e-6, rhoIz = 2e-4 }
[rod.b]
section = "s"
line = { from = [0.1, 0, 0], to = [1.6, 0, 0] }
y_axis = [0, 1, 0.2]
elements = 10
order = 2
[[support]]
at = "b.start"
fix = ["x", "y", "z", "rx", "ry"]
move = { rz = "4*t*t" }
[[load]]
on = "b"
force_per_length = [0, 0, "sin(20*t)*3"]
[analysis]
kind = "dynamic"
end_time = 0.7
time_step = 2e-3
integrator = ")" + std::string(integrator) +
                                 "\"\n";
        CHECK(run(deck).cuts == 0);
        // With sdirk-4, the fraction of whose step is a quarter, none either, but more iterations.
        if (integrator != std::string("sdirk-4")) CHECK(run(deck + consistent).cuts > 20);
    }
}

TEST_CASE("A wire that twist hardly turns is thrown in as many steps", "[issues]") {
    const std::string deck = R"([section.s]
stiffness = { EA = 1e4, GAy = 1e4, GAz = 1e4, GJ = 1e4, EIy = 1e-2, EIz = 1e-2 }
inertia = { rhoA = 0.1, rhoIy = 1e-6, rhoIz = 1e-6 }
[rod.w]
section = "s"
arc = { centre = [0, 0, 0], axis = [0, 0, 1], from = [1, 0, 0], angle = 2.5 }
elements = 20
[[load]]
at = "w.start"
force = [0, "t < 0.2 ? 0.3 : 0", "t < 0.2 ? 1 : 0"]
[analysis]
kind = "dynamic"
end_time = 1.0
time_step = 5e-3
integrator = "generalized-alpha"
)";
    CHECK(run(deck).cuts == 0);
    CHECK(run(deck + consistent).cuts > 5);
}

TEST_CASE("Rods without a nearly rigid direction move as before to the last bit", "[issues]") {
    for (const char* EIz : {"0.004", "1.0"}) {
        const std::string deck = make_tape(strip_section(EIz));
        CHECK(run(deck).end == run(deck + consistent).end);
    }
}

}  // namespace gxrod::test
