#include "deck/decks.hpp"

namespace gxrod::test {

TEST_CASE("One rotation alone cannot be fixed", "[deck]") {
    CHECK(faults_of(body_deck + R"([[support]]
at = "top"
fix = ["x", "ry"])") ==
          "x.toml:10:13: support[0].fix[1]: ry alone cannot be fixed: what stays free would depend on the "
          "path of the motion; expected two of rx, ry, rz (a hinge about the third axis), all three or none");
    CHECK(faults_of(body_deck + R"([[support]]
at = "top"
fix = "rz")") ==
          "x.toml:10:7: support[0].fix: rz alone cannot be fixed: what stays free would depend on the path "
          "of the motion; expected two of rx, ry, rz (a hinge about the third axis), all three or none");
    CHECK(faults_of(body_deck + R"([[support]]
at = "top"
fix = "position"
[[support]]
at = "top"
fix = ["rz"])") ==
          "x.toml:13:8: support[1].fix[0]: rz alone cannot be fixed: what stays free would depend on the "
          "path of the motion; expected two of rx, ry, rz (a hinge about the third axis), all three or none");
}

TEST_CASE("A support does not hold a velocity that a body starts with", "[deck]") {
    CHECK(faults_of(replaced(body_deck, "inertia", R"(velocity = [0, 1, 0]
inertia)"),
                    {R"(support=[{at = "top", fix = "position"}])"}) ==
          "x.toml:3:12: body.top.velocity: a [[support]] fixes y here; expected 0 along it");
    CHECK(faults_of(replaced(body_deck, "inertia", R"(angular_velocity = [0, 1, 0]
inertia)"),
                    {R"(support=[{at = "top", fix = ["rx", "ry"]}])"}) ==
          "x.toml:3:20: body.top.angular_velocity: a [[support]] fixes ry here; expected 0 along it");
    CHECK(
        faults_of(replaced(body_deck, "inertia", R"(angular_velocity_material = [0, 0, 1]
inertia)"),
                  {R"(support=[{at = "top", fix = "rotation"}])"}) ==
        "x.toml:3:29: body.top.angular_velocity_material: a [[support]] fixes rz here; expected 0 along it");
}

TEST_CASE("Something can move", "[deck]") {
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

TEST_CASE("A velocity that a support leaves free stays, round-off in the others goes", "[deck]") {
    const Problem problem =
        read(replaced(body_deck,
                      "inertia",
                      "rotation_vector = [0.3, 0, 0]\nvelocity = [0, 1, 0]\n"
                      "angular_velocity_material = [0, \"50*sin(0.3)\", \"50*cos(0.3)\"]\ninertia") +
             "[[support]]\nat = \"top\"\nfix = [\"x\", \"z\", \"rx\", \"ry\"]\n");
    CHECK(problem.model.nodes[0].velocity == Vec3(0, 1, 0));
    CHECK(problem.model.nodes[0].angular_velocity[1] == 0.0);
    CHECK(problem.model.nodes[0].angular_velocity[2] == Approx(50.0));
}

}  // namespace gxrod::test
