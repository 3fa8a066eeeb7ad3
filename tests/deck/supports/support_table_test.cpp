
#include "deck/decks.hpp"

#include "tools/catch.hpp"

namespace gxrod::test {

TEST_CASE("One rotation alone cannot be fixed", "[deck]") {
    CHECK(
        faults_of(body_deck + R"([[support]]
at = "top"
fix = ["x", "ry"])") ==
        "x.toml:10:13: support[0].fix[1]: ry alone cannot be fixed: what stays free would depend on the "
        "path of the motion; expected two of rx, ry, rz (a hinge about the third axis), all three or none; "
        "or, for the turn about one axis, a joint of type \"free\" from the ground with move = { turn = 0 }");
    CHECK(
        faults_of(body_deck + R"([[support]]
at = "top"
fix = "rz")") ==
        "x.toml:10:7: support[0].fix: rz alone cannot be fixed: what stays free would depend on the path "
        "of the motion; expected two of rx, ry, rz (a hinge about the third axis), all three or none; "
        "or, for the turn about one axis, a joint of type \"free\" from the ground with move = { turn = 0 }");
    CHECK(
        faults_of(body_deck + R"([[support]]
at = "top"
fix = "position"
[[support]]
at = "top"
fix = ["rz"])") ==
        "x.toml:13:8: support[1].fix[0]: rz alone cannot be fixed: what stays free would depend on the "
        "path of the motion; expected two of rx, ry, rz (a hinge about the third axis), all three or none; "
        "or, for the turn about one axis, a joint of type \"free\" from the ground with move = { turn = 0 }");
}

TEST_CASE("Something can move", "[deck]") {
    CHECK(faults_of(body_deck + R"([[support]]
at = "top"
fix = ["y", "z", "rotation"]
move = { x = "t" })")
              .empty());
    CHECK(faults_of(body_deck + R"([[support]]
at = "top"
fix = "all")") == "x.toml:10:7: support[0].fix: every node of the deck is fixed; nothing can move");
}

TEST_CASE("Supports of one node add up", "[deck]") {
    const auto fixed = [](const std::string& supports) { return read(rod_deck + supports).model.supports; };
    const auto all = fixed(
        "[[support]]\nat = \"r.end\"\nfix = [\"x\", \"x\", \"rx\"]\n"
        "[[support]]\nat = \"r.start\"\nfix = \"all\"\n"
        "[[support]]\nat = \"r@1\"\nfix = [\"x\", \"ry\"]\n");
    REQUIRE(all.size() == 2);
    CHECK(all[0].node == 10);
    CHECK(all[0].fixed == std::array{true, false, false, true, true, false});
    CHECK(all[1].node == 0);
    CHECK(all[1].fixed == std::array{true, true, true, true, true, true});
    CHECK(fixed("[[support]]\nat = \"r.end\"\nfix = [\"position\", \"rotation\"]\n")[0].fixed ==
          all[1].fixed);
    CHECK(fixed("[[support]]\nat = \"r.end\"\nfix = \"rotation\"\n")[0].fixed ==
          std::array{false, false, false, true, true, true});
}

TEST_CASE("A component is fixed or moved, once", "[deck]") {
    const std::string support = body_deck + "[[support]]\nat = \"top\"\n";
    CHECK(faults_of(support + "fix = [\"x\", \"y\"]\nmove = { z = \"t\", y = \"t\" }\n") ==
          "x.toml:11:23: support[0].move.y: this support fixes y here; a component is fixed or moved, never "
          "both");
    CHECK(faults_of(support + "fix = [\"x\", \"y\"]\n[[support]]\nat = \"top\"\nmove = { y = \"t\" }\n") ==
          "x.toml:13:14: support[1].move.y: support[0] fixes y here; a component is fixed or moved, never "
          "both");
    CHECK(faults_of(support +
                    "move = { y = \"t\" }\n[[support]]\nat = \"top\"\nfix = [\"x\", \"position\"]\n") ==
          "x.toml:13:13: support[1].fix[1]: support[0] moves y here; a component is fixed or moved, never "
          "both");
    CHECK(faults_of(support + "move = { y = \"t\" }\n[[support]]\nat = \"top\"\nmove = { y = \"t\" }\n") ==
          "x.toml:13:14: support[1].move.y: support[0] moves y here too");
    CHECK(faults_of(support + "move = {}\n") ==
          "x.toml:8:1: support[0]: missing; expected fix or move = { … } or stiffness = { … } or damping = { "
          "… } or vessel");
}

TEST_CASE("A rotation moves with the other two fixed or moved", "[deck]") {
    const std::string support = body_deck + "[[support]]\nat = \"top\"\n";
    CHECK(
        faults_of(support + "move = { rz = \"t\" }\n") ==
        "x.toml:10:15: support[0].move.rz: where a rotation moves, the other two must be fixed or moved too; "
        "free: rx, ry; or, for the turn about one axis, a joint of type \"free\" from the ground with "
        "move = { turn = … }");
    CHECK(
        faults_of(support + "fix = \"rx\"\nmove = { rz = \"t\" }\n") ==
        "x.toml:11:15: support[0].move.rz: where a rotation moves, the other two must be fixed or moved too; "
        "free: ry");
    CHECK(faults_of(support + "fix = [\"rx\"]\nmove = { ry = \"2*t\", rz = \"t\" }\n").empty());
    CHECK(faults_of(support + "move = { x = \"2*t\" }\n").empty());
}

TEST_CASE("A move is 0 at the start of a dynamic analysis", "[deck]") {
    const std::string support = "[[support]]\nat = \"r.start\"\nfix = \"rotation\"\nmove = { x = ";
    CHECK(
        faults_of(rod_deck + support + "\"cos(t)\" }\n") ==
        "x.toml:16:14: support[0].move.x: is 1 at t = 0; expected 0 there, since the deck says where things "
        "are at t = 0");
    CHECK(faults_of(rod_deck + support + "0.5 }\n") ==
          "x.toml:16:14: support[0].move.x: is 0.5 at t = 0; expected 0 there, since the deck says where "
          "things are at t = 0");
    CHECK(faults_of(rod_deck + support + "\"sin(t + 2*pi)\" }\n").empty());
    CHECK(faults_of(static_rod_deck + support + "\"cos(t)\" }\n").empty());
}

TEST_CASE("Moves are functions of time, in a static deck multiplied by the load factor", "[deck]") {
    const std::string support =
        "[[support]]\nat = \"r.start\"\nfix = \"rx\"\n"
        "[[support]]\nat = \"r.start\"\nmove = { y = \"0\", z = \"2*t^2\", ry = \"3*t\", rz = \"0\" }\n";
    const Support moved = read(rod_deck + support).model.supports.at(0);
    CHECK(moved.fixed == std::array{false, false, false, true, false, false});
    CHECK(moved.moved == std::array{false, true, true, false, true, true});
    CHECK(moved.motion[1].is_zero());
    CHECK(moved.motion[2](3.0) == 18.0);
    CHECK(moved.motion[4](0.5) == 1.5);
    CHECK(moved.axes.coeffs() == Quat::Identity().coeffs());
    const Model grown = read(static_rod_deck + replaced(support, "y = \"0\"", "y = \"4\"")).model;
    CHECK(grown.supports[0].motion[1](0.25) == 1.0);
    CHECK(grown.supports[0].motion[2](0.5) == 0.5);
}

TEST_CASE("Axes of a support are orthonormal and right-handed", "[deck]") {
    const auto fault = [](const std::string& axes) {
        return faults_of(body_deck + "[[support]]\nat = \"top\"\nfix = \"x\"\naxes = " + axes + "\n");
    };
    const std::string start =
        "x.toml:11:8: support[0].axes: expected three rows of length 1 at right angles to each other, "
        "right-handed; ";
    CHECK(fault("[[1, 0, 0], [0, 2, 0], [0, 0, 1]]") == start + "the second row has length 2");
    CHECK(fault("[[1, 0, 0], [0, 1, 0], [0, 0.70710678118654752, 0.70710678118654752]]") ==
          start + "the second and third row are not at right angles");
    CHECK(fault("[[1, 0, 0], [0, 1, 0], [0.6, 0, 0.8]]") ==
          start + "the first and third row are not at right angles");
    CHECK(fault("[[1, 0, 0], [0, 1, 0], [0, 0, -1]]") ==
          start + "the third row is opposite to first × second");
    CHECK(
        fault("[1, 0, 0]") ==
        "x.toml:11:9: support[0].axes[0]: expected an array of 3 rows of 3 numbers or expressions, found 1\n"
        "x.toml:11:12: support[0].axes[1]: expected an array of 3 rows of 3 numbers or expressions, found 0\n"
        "x.toml:11:15: support[0].axes[2]: expected an array of 3 rows of 3 numbers or expressions, found 0");
    CHECK(fault("3") ==
          "x.toml:11:8: support[0].axes: expected an array of 3 rows of 3 numbers or expressions, found 3");
    CHECK(fault("[[0.8, 0.6, 0], [-0.6, 0.8000008, 0], [0, 0, 1]]").empty());
    CHECK_FALSE(fault("[[0.8, 0.6, 0], [-0.6, 0.800003, 0], [0, 0, 1]]").empty());
}

TEST_CASE("Rows of axes are the support's x, y and z", "[deck]") {
    const Support support =
        read(body_deck +
             "[[support]]\nat = \"top\"\nfix = \"x\"\naxes = [[0.8, 0.6000001, 0], [-0.6, 0.8, 0], "
             "[0, 0, 1]]\n")
            .model.supports[0];
    CHECK((support.axes * Vec3::UnitX() - Vec3(0.8, 0.6, 0)).norm() < 1e-6);
    CHECK((support.axes * Vec3::UnitY() - Vec3(-0.6, 0.8, 0)).norm() < 1e-6);
    CHECK((support.axes * Vec3::UnitZ() - Vec3(0, 0, 1)).norm() < 1e-6);
    CHECK(support.axes.norm() == Approx(1.0).epsilon(1e-15));
}

TEST_CASE("Supports of one node share their axes", "[deck]") {
    const std::string first =
        "[[support]]\nat = \"top\"\nfix = \"x\"\naxes = [[0, 1, 0], [0, 0, 1], [1, 0, 0]]\n";
    const std::string second = "[[support]]\nat = \"top\"\nfix = \"z\"\n";
    CHECK(faults_of(body_deck + first + second) ==
          "x.toml:12:1: support[1].axes: support[0] is at the same node and has other axes; supports of one "
          "node share theirs");
    CHECK(faults_of(body_deck + first + second + "axes = [[0, 1, 0], [0, 0, -1], [-1, 0, 0]]\n") ==
          "x.toml:15:8: support[1].axes: support[0] is at the same node and has other axes; supports of one "
          "node share theirs");
    CHECK(faults_of(body_deck + first + second + "axes = [[0, 1, 0], [0, 0, 1], [1, 0, 0]]\n").empty());
}

}  // namespace gxrod::test
