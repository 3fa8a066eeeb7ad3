
#include "deck/decks.hpp"

#include "tools/catch.hpp"

namespace gxrod::test {

TEST_CASE("Points that do not exist are errors that name the nearest one", "[deck]") {
    CHECK(faults_of(rod_deck + R"([[load]]
at = "r"
force = [0, 0, 1])") ==
          R"(x.toml:14:6: load[0].at: "r" is a rod; expected a point of it: r.start, r.end or r@FRACTION)");
    CHECK(faults_of(rod_deck + R"([[load]]
at = "r.ent"
force = [0, 0, 1])") == R"(x.toml:14:6: load[0].at: no point "r.ent"; did you mean "r.end"?)");
    CHECK(faults_of(rod_deck + R"([[load]]
at = "r.middle"
force = [0, 0, 1])") ==
          R"(x.toml:14:6: load[0].at: no point "r.middle"; a rod has r.start, r.end and r@FRACTION)");
    CHECK(faults_of(rod_deck + R"([[load]]
at = "q.start"
force = [0, 0, 1])") == R"(x.toml:14:6: load[0].at: no point "q.start"; did you mean "r.start"?)");
    CHECK(faults_of(rod_deck + R"([[load]]
at = "rr.end"
force = [0, 0, 1])") == R"(x.toml:14:6: load[0].at: no point "rr.end"; did you mean "r.end"?)");
    CHECK(faults_of(rod_deck + R"([[load]]
at = "x"
force = [0, 0, 1])") == R"(x.toml:14:6: load[0].at: no point "x"; the deck has r.start, r.end)");
    CHECK(faults_of(rod_deck + R"([[load]]
at = "r@1.5"
force = [0, 0, 1])") == R"(x.toml:14:6: load[0].at: expected a fraction from 0 to 1 after "@", found "1.5")");
    CHECK(faults_of(rod_deck + R"([[load]]
at = "r@"
force = [0, 0, 1])") == R"(x.toml:14:6: load[0].at: expected a fraction from 0 to 1 after "@", found "")");
    CHECK(faults_of(rod_deck + R"([[load]]
at = "r@half"
force = [0, 0, 1])") ==
          R"(x.toml:14:6: load[0].at: expected a fraction from 0 to 1 after "@", found "half")");
    CHECK(faults_of(rod_deck + R"([[load]]
at = "r@-0.1"
force = [0, 0, 1])") ==
          R"(x.toml:14:6: load[0].at: expected a fraction from 0 to 1 after "@", found "-0.1")");
    CHECK(faults_of(rod_deck + R"([[load]]
at = ""
force = [0, 0, 1])") == R"(x.toml:14:6: load[0].at: no point ""; the deck has r.start, r.end)");
    CHECK(faults_of(body_deck + R"([[load]]
at = "top.end"
force = [0, 0, 1])") == R"(x.toml:9:6: load[0].at: "top" is a body; its point is "top")");
    CHECK(faults_of(body_deck + R"([[load]]
at = "tap"
force = [0, 0, 1])") == R"(x.toml:9:6: load[0].at: no point "tap"; did you mean "top"?)");
    CHECK(faults_of(body_deck + R"([[load]]
at = "far"
force = [0, 0, 1])") == R"(x.toml:9:6: load[0].at: no point "far"; the deck has top)");
    CHECK(faults_of(replaced(body_deck, "mass = 1.0", R"(mass = 1.0
at = "top")")) == R"(x.toml:3:6: body.top.at: "top" is a body; expected a point of a rod)");
    CHECK(faults_of(rod_deck + R"([body.b]
mass = 1
inertia = [1, 1, 1]
at = "r.stop")") == R"(x.toml:16:6: body.b.at: no point "r.stop"; a rod has r.start, r.end and r@FRACTION)");
}

}  // namespace gxrod::test
