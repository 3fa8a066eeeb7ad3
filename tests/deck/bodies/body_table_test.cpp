
#include "deck/decks.hpp"

#include "tools/catch.hpp"

namespace gxrod::test {

TEST_CASE("Inertias that no body has are errors", "[deck]") {
    CHECK(faults_of(replaced(body_deck, "[1, 1, 1]", "[1, 1, 0]")) ==
          "x.toml:3:11: body.top.inertia: expected a positive definite inertia, found principal moments 0, "
          "1, 1; a rotation without inertia cannot be integrated in time");
    CHECK(faults_of(replaced(body_deck, "[1, 1, 1]", "[1, 1, -1]")) ==
          "x.toml:3:11: body.top.inertia: expected a positive definite inertia, found principal moments -1, "
          "1, 1; a rotation without inertia cannot be integrated in time");
    CHECK(faults_of(replaced(body_deck, "[1, 1, 1]", "[1, 1, 2.3]")) ==
          "x.toml:3:11: body.top.inertia: no body has the principal moments 1, 1, 2.3: the largest cannot be "
          "above the sum of the others; expected 2 at most, or greater values of the others");
    CHECK(faults_of(replaced(body_deck, "[1, 1, 1]", "[[1, 0.1, 0], [0.2, 1, 0], [0, 0, 1]]")) ==
          "x.toml:3:11: body.top.inertia: expected a symmetric matrix");
    CHECK(faults_of(replaced(body_deck, "[1, 1, 1]", "[[1, 2, 0], [2, 1, 0], [0, 0, 1]]")) ==
          "x.toml:3:11: body.top.inertia: expected a positive definite inertia, found principal moments -1, "
          "1, 3; a rotation without inertia cannot be integrated in time");
}

TEST_CASE("Mass and inertia can be left out where nothing needs them", "[deck]") {
    const std::string missing = "; a rotation without inertia cannot be integrated in time";
    CHECK(
        faults_of(replaced(body_deck, "mass = 1.0\ninertia = [1, 1, 1]\n", "")) ==
        "x.toml:1:1: body.top.mass: missing; expected a number greater than 0 or an expression\n"
        "x.toml:1:1: body.top.inertia: missing; expected an array of 3 numbers or expressions, or of 3 such "
        "arrays" +
            missing);
    const Model statics = read(static_rod_deck + "[body.a]\nat = \"r.end\"\n[body.b]\n").model;
    CHECK(statics.bodies[0].mass == 0.0);
    CHECK(statics.bodies[1].inertia == Mat3::Zero());
    const std::string tip = rod_deck + "[body.tip]\nmass = 2\nat = \"r.end\"\n";
    CHECK(read(tip).model.bodies[0].inertia == Mat3::Zero());
    CHECK(faults_of(tip + "inertia = [0, 1, 1]\n").empty());
    CHECK(
        faults_of(tip + "inertia = [-0.1, 1, 1]\n") ==
        "x.toml:16:11: body.tip.inertia: expected principal moments that are not negative, found -0.1, 1, 1");
    const Problem still = read(static_rod_deck + "[body.a]\nat = \"r.end\"\nvelocity = [1, 0, 0]\n");
    CHECK(still.notes.back() ==
          "body.a.velocity: without effect: velocities act in dynamic analyses, and the deck has none");
}

TEST_CASE("A body is at a point of a rod, whose velocity one body sets", "[deck]") {
    CHECK(faults_of(replaced(body_deck, "mass = 1.0", R"(mass = 1.0
at = "top")")) == R"(x.toml:3:6: body.top.at: "top" is a body; expected a point of a rod)");
    CHECK(faults_of(rod_deck + R"([body.a]
mass = 1
inertia = [1, 1, 1]
at = "r.end"
velocity = [1, 0, 0]
[body.b]
mass = 1
inertia = [1, 1, 1]
at = "r.end"
velocity = [1, 0, 0])") == "x.toml:22:12: body.b.velocity: body.a is at the same node and sets it too");
    CHECK(faults_of(rod_deck + R"([body.a]
mass = 1
inertia = [1, 1, 1]
at = "r.end"
angular_velocity = [1, 0, 0]
[body.b]
mass = 1
inertia = [1, 1, 1]
at = "r@1"
angular_velocity_material = [1, 0, 0])") ==
          "x.toml:22:29: body.b.angular_velocity_material: body.a is at the same node and sets it too");
}

TEST_CASE("A rod and a body have different names", "[deck]") {
    CHECK(faults_of(rod_deck + R"([body.r]
mass = 1
inertia = [1, 1, 1])") == "x.toml:13:1: body.r: rod.r has this name too, and points go by it");
}

TEST_CASE("Inertias that are valid up to round-off are taken, symmetric to the last bit", "[deck]") {
    CHECK(faults_of(replaced(body_deck, "[1, 1, 1]", "[0.234375, 0.46875, 0.234375]")).empty());
    CHECK(faults_of(replaced(body_deck, "[1, 1, 1]", "[0.1, 0.2, \"0.1 + 0.2 + 1e-12\"]")).empty());
    const Problem problem =
        read(replaced(body_deck, "[1, 1, 1]", "[[2, 0.1, 0], [\"0.1 + 1e-12\", 2, 0.3], [0, 0.3, 2]]"));
    const Mat3& inertia = problem.model.bodies[0].inertia;
    CHECK(inertia == inertia.transpose());
    CHECK(inertia(0, 1) == Approx(0.1));
    CHECK(inertia(1, 2) == 0.3);
}

TEST_CASE("Bodies stand in order, with a node each or that of a rod", "[deck]") {
    const std::string body = "mass = 1\ninertia = [1, 1, 1]\n";
    const Problem problem = read(rod_deck + "[body.b]\n" + body + "at = [1, 2, 3]\n[body.a]\n" + body +
                                 "at = \"r.end\"\nvelocity = [1, 0, 0]\n[body.c]\n" + body +
                                 "at = \"r.end\"\nangular_velocity = [0, 0, 1]\n");
    REQUIRE(problem.model.bodies.size() == 3);
    CHECK(problem.model.bodies[0].name == "b");
    CHECK(problem.model.bodies[0].node == 11);
    CHECK(problem.model.nodes[11].name == "b");
    CHECK(problem.model.bodies[1].node == 10);
    CHECK(problem.model.bodies[2].node == 10);
    CHECK(problem.model.nodes.size() == 12);
    CHECK(problem.model.nodes[10].velocity == Vec3(1, 0, 0));
    CHECK(problem.model.nodes[10].angular_velocity == Vec3(0, 0, 1));
    CHECK(problem.model.nodes[9].velocity == Vec3(0, 0, 0));
}

}  // namespace gxrod::test
