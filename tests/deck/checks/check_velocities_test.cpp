#include "deck/checks/check_velocities.hpp"

#include "deck/decks.hpp"
#include "tools/catch.hpp"

namespace gxrod::test {
namespace {

std::string with_body_line(const std::string& line) {
    return replaced(body_deck, "inertia", line + "\ninertia");
}

}  // namespace

TEST_CASE("A fixed component does not start with a velocity", "[deck]") {
    CHECK(
        faults_of(with_body_line("velocity = [0, 1, 0]"), {R"(support=[{at = "top", fix = "position"}])"}) ==
        "x.toml:3:12: body.top.velocity: a [[support]] fixes y at top; expected 0 along it, found 1");
    CHECK(faults_of(with_body_line("angular_velocity = [0, 1, 0]"),
                    {R"(support=[{at = "top", fix = ["rx", "ry"]}])"}) ==
          "x.toml:3:20: body.top.angular_velocity: a [[support]] fixes ry at top; expected 0 along it, found "
          "1");
    CHECK(faults_of(with_body_line("angular_velocity_material = [0, 0, 2]"),
                    {R"(support=[{at = "top", fix = "rotation"}])"}) ==
          "x.toml:3:29: body.top.angular_velocity_material: a [[support]] fixes rz at top; expected 0 "
          "along it, found 2");
    CHECK(faults_of(rod_deck + R"([[support]]
at = "r@0.5"
fix = "position"
[[initial]]
on = "r"
velocity = [0, "s", 0])") ==
          "x.toml:18:12: initial[0].velocity: a [[support]] fixes y at r@0.5; expected 0 along it, found 5");
}

TEST_CASE("Velocities are checked in the support's own axes", "[deck]") {
    const auto fault = [](const std::string& velocity) {
        return faults_of(
            with_body_line("velocity = " + velocity) +
            "[[support]]\nat = \"top\"\nfix = \"x\"\naxes = [[0.6, 0.8, 0], [-0.8, 0.6, 0], [0, 0, 1]]\n");
    };
    CHECK(
        fault("[0, 5, 0]") ==
        "x.toml:3:12: body.top.velocity: a [[support]] fixes x of its own axes at top; expected 0 along it, "
        "found 4");
    CHECK(fault("[-4, 3, 1]").empty());
}

TEST_CASE("A moved component starts with the rate of its motion", "[deck]") {
    const auto fault = [](const std::string& spin) {
        return faults_of(with_body_line("angular_velocity = " + spin) +
                         "[function.f]\ntable = [[0, 0], [1, 7]]\n[[support]]\nat = \"top\"\nfix = \"rx\"\n"
                         "move = { ry = \"2*sin(3*t)\", rz = \"f(t)\" }\n");
    };
    CHECK(fault("[0, 6, 7]").empty());
    CHECK(fault("[0, 5, 7]") ==
          "x.toml:3:20: body.top.angular_velocity: a [[support]] moves ry at top; expected the rate of its "
          "motion at t = 0, 6, found 5");
    CHECK(fault("[0, 6, 7.001]") ==
          "x.toml:3:20: body.top.angular_velocity: a [[support]] moves rz at top; expected the rate of its "
          "motion at t = 0, 7, found 7.001");
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
