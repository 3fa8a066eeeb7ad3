#include "check/summaries/condition_summary.hpp"

#include "deck/decks.hpp"
#include "deck/reading/input_uses.hpp"
#include "tools/catch.hpp"

namespace gxrod::test {
namespace {

std::string describe_conditions(const Model& model) {
    std::string text;
    for (const ItemList& list : list_conditions(model)) text += describe(list, Detail::all);
    return text;
}

}  // namespace

TEST_CASE("The summary lists connections, supports, velocities, loads and gravity", "[check]") {
    const std::string deck = "gravity = [0, 0, -9.81]\n" + rod_deck + R"deck([rod.q]
section = "s"
line = { from = [10, 0, 0], to = [10, 5, 0] }
elements = 4
element = "simo"
[body.tip]
mass = 2
at = "q.end"
angular_velocity = [0, 0, 2]
[[connect]]
points = ["r.end", "q.start"]
[[support]]
at = "r.start"
fix = ["y", "rx", "ry"]
move = { x = "0.1*sin(t)", rz = "t" }
[[support]]
at = "r@0.5"
fix = "x"
axes = [[0, 1, 0], [-1, 0, 0], [0, 0, 1]]
[[initial]]
on = "q"
velocity = [3, "2*0", 4]
[[load]]
at = "tip"
moment = [0, 0, 1]
frame = "body"
[[load]]
on = "q"
force_per_length = [0, 0, "s"]
)deck";
    CHECK(
        describe_conditions(read(deck).model) ==
        "connection: r.end is one node of rods r, q\n"
        "support at r.start: fixes y rx ry, moves x rz\n"
        "support at r@0.5: fixes x; x (0, 1, 0), y (-1, 0, 0), z (0, 0, 1)\n"
        "initial velocities of rod r: up to 5, angular velocities up to 0, stretched and sheared at up to 5\n"
        "initial velocities of rod q: up to 5, angular velocities up to 2, stretched and sheared at up to 1\n"
        "initial velocities of body tip: up to 5, angular velocities up to 2\n"
        "load[0] at q.end: moment, body\n"
        "load[1] on rod q: force per length, spatial\n"
        "gravity (0, 0, -9.81)\n");
    CHECK(describe_conditions(read("gravity = [0, 0, \"-2*t\"]\n" + rod_deck).model) ==
          "gravity grows with t, to (0, 0, -2) at t = 1\n");
    CHECK(describe_conditions(read(rod_deck).model).empty());
}

TEST_CASE("The summary lists tendons with path and pull, and inputs with what reads them", "[check]") {
    const std::string deck = R"deck([section.w]
shape = { circle = { radius = 1e-3 } }
material = { E = 200e9, G = 80e9, density = 8000 }
[rod.arm]
section = "w"
line = { from = [0, 0, 0], to = [0.5, 0, 0] }
elements = 12
order = 3
y_axis = [0, 1, 0]
[input.pull]
value = 3
[input.idle]
hold = "linear"
[tendon.idle]
on = "arm"
offset = ["0.015*cos(4*pi*s)", "0.015*sin(4*pi*s)"]
tension = "2*pull"
to = 0.75
friction = 0.3
[tendon.winch]
on = "arm"
offset = [[0, 0, 0.003], [1, 0, 0.303]]
shortening = "2e-3*pull"
stiffness = 1e4
slack = false
[analysis]
kind = "static"
)deck";
    const Model model = read(deck).model;
    // The helix is 0.375 √(1 + (0.06 π)²) long and turns by 0.375 × 0.015 (4π)² / √(1 + (0.06 π)²) = 0.8729,
    // of which the angles between its force points miss what is before the first and behind the last one.
    CHECK(describe(list_tendons(model), Detail::all) ==
          "tendon idle: in rod arm from s = 0 to 0.375, at (y, z) = (0.015, 0) to (0, -0.015), 0.381604 "
          "long; tension changes with t, 6 at t = 1; friction 0.3, pulled at its start: at t = 0 it turns by "
          "0.8721, which leaves 77 % of the tension\n"
          "tendon winch: in rod arm, at (y, z) = (0, 0.003) to (0, 0.303), 0.583095 long; shortening changes "
          "with t, 0.006 at t = 1, EA 10000, pushes where it is too long\n");
    CHECK(describe(list_inputs(model, {find_input_uses(read_toml(deck, "arm.toml"))}), Detail::all) ==
          "input pull: 3 at t = 0, between two values a step; read by tendon.idle.tension, "
          "tendon.winch.shortening\n"
          "input idle: 0 at t = 0, between two values a straight line\n");
}

TEST_CASE("The summary names chambers", "[check]") {
    const std::string deck =
        rod_deck +
        "[input.p]\n[chamber.bellows]\non = \"r\"\noffset = [0, 0.1]\narea = 2\npressure = \"p\"\n";
    const DeckWords words{{}, list_table_names(read_toml(deck, "arm.toml"), "chamber")};
    CHECK(describe(list_tendons(read(deck).model, words), Detail::all) ==
          "chamber bellows: in rod r, at (y, z) = (0, 0.1), 10 long; −p A changes with t, 0 at t = 1\n");
}

}  // namespace gxrod::test
