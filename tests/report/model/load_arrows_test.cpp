#include "report/model/load_arrows.hpp"

#include <numbers>

#include "deck/problem.hpp"
#include "rotation/rotation_map.hpp"
#include "tools/catch.hpp"

using namespace gxrod;

TEST_CASE("Loads are drawn with the value of their time and the turn of their node", "[report]") {
    const Problem problem = read_problem_text(R"(
[section.s]
stiffness = { EA = 1e3, GAy = 1e3, GAz = 1e3, GJ = 1, EIy = 1, EIz = 1 }
[rod.bar]
section = "s"
line = { from = [0, 0, 0], to = [2, 0, 0] }
elements = 4
[[support]]
at = "bar.start"
fix = "all"
[[load]]
at = "bar.end"
force = ["3*t", 0, 0]
moment = [0, "t", 0]
[[load]]
at = "bar.end"
force = ["2*t", 0, 0]
frame = "follower"
[[load]]
on = "bar"
force_per_length = [0, 0, "t*s"]
[analysis]
kind = "static"
)",
                                              "bar.toml");
    const std::vector<LoadArrow> arrows = list_load_arrows(problem.model);
    REQUIRE(arrows.size() == 2 + 8);
    NodeMotion turned;
    turned.Lambda = exp_quaternion(Vec3(0, 0, std::numbers::pi / 2));
    Vec6 expected;
    expected << 1.5, 0, 0, 0, 0.5, 0;
    CHECK((arrows[0].value(turned, 0.5) - expected).norm() < 1e-12);
    expected << 0, 1, 0, 0, 0, 0;
    CHECK((arrows[1].value(turned, 0.5) - expected).norm() < 1e-12);
    expected << 0, 0, 1, 0, 0, 0;
    CHECK(arrows.back().is_along_rod);
    CHECK(arrows.back().node == arrows[0].node);
    CHECK((arrows.back().value(turned, 0.5) - expected).norm() < 1e-12);
}

TEST_CASE("Loads along a rod turn with it where they follow it", "[report]") {
    const Problem problem = read_problem_text(R"(
[section.s]
stiffness = { EA = 1e3, GAy = 1e3, GAz = 1e3, GJ = 1, EIy = 1, EIz = 1 }
[rod.bar]
section = "s"
line = { from = [0, 0, 0], to = [0, 2, 0] }
elements = 2
[[support]]
at = "bar.start"
fix = "all"
[[load]]
on = "bar"
force_per_length = ["t", 0, 0]
moment_per_length = [0, "2*t", 0]
frame = "follower"
[[load]]
on = "bar"
force_per_length = ["t", 0, 0]
frame = "body"
[analysis]
kind = "static"
)",
                                              "bar.toml");
    const std::vector<LoadArrow> arrows = list_load_arrows(problem.model);
    REQUIRE(arrows.size() == 2 * 4);
    NodeMotion turned;
    turned.Lambda = exp_quaternion(Vec3(0, 0, std::numbers::pi / 2));
    Vec6 expected;
    expected << 0, 0.5, 0, -1, 0, 0;
    CHECK((arrows[0].value(turned, 0.5) - expected).norm() < 1e-12);
    // Section x is along y.
    expected << -0.5, 0, 0, 0, 0, 0;
    CHECK((arrows[4].value(turned, 0.5) - expected).norm() < 1e-12);
}
