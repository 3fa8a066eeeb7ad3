#include "check/summaries/condition_summary.hpp"

#include "deck/decks.hpp"
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

}  // namespace gxrod::test
