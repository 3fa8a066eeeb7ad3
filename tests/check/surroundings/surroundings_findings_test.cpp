#include "check/surroundings/surroundings_findings.hpp"

#include "check/findings/plane_findings.hpp"
#include "deck/surroundings/surroundings_decks.hpp"
#include "tools/catch.hpp"

namespace gxrod::test {
namespace {

using Catch::Contains;

std::string findings_of(const std::string& deck) {
    const Problem problem = read(deck);
    std::string all;
    for (const Finding& finding : examine_surroundings(problem.model, problem.analysis()))
        all += finding.message + "\n";
    return all;
}

// A wave in deep water; the rod is 10 long, with 4 elements, and the step 0.1.
std::string with_wave(const std::string& keys, const std::string& more = "") {
    return tube_deck() + water_deck + more + "[[wave]]\nairy = { " + keys + " }\n";
}

}  // namespace

TEST_CASE("A wave that would break is a finding", "[check]") {
    CHECK(findings_of(with_wave("height = 2, period = 8")).empty());
    // λ = g T²/(2 π) = 25 of T = 4, and 25/7 = 3.57.
    CHECK(findings_of(with_wave("height = 3.5, period = 4")).empty());
    CHECK_THAT(findings_of(with_wave("height = 3.6, period = 4")),
               Contains("steepness 0.144; waves break at 1/7"));
    CHECK_THAT(findings_of(with_wave("height = 3.2, period = 20", "depth = 4\n")),
               Contains("too high for the depth 4; waves break at 0.78 of it"));
    CHECK(findings_of(with_wave("height = 3.1, period = 20", "depth = 4\n")).empty());
}

TEST_CASE("Steps and elements that do not resolve waves are findings", "[check]") {
    CHECK_THAT(findings_of(with_wave("height = 0.01, period = 0.9")),
               Contains("has the period 0.9, 9 steps; expected time_step = 0.045 or less"));
    // λ = 6.25 of T = 2, two and a half elements.
    CHECK_THAT(findings_of(with_wave("height = 0.1, period = 2")),
               Contains("2.5 elements of rod r; expected 17 elements or more"));
    CHECK(findings_of(replaced(with_wave("height = 0.1, period = 2"), "elements = 4", "elements = 17"))
              .empty());
    CHECK_THAT(findings_of(tube_deck() + water_deck + "[[wave]]\njonswap = { Hs = 1, Tp = 2 }\n"),
               Contains("the mean wave of the sea"));
}

TEST_CASE("A depth that is not the ground's, and a soft ground, are findings", "[check]") {
    const std::string ground = "[seabed]\nz = -12\nstiffness = 1e5\n";
    CHECK(findings_of(with_wave("height = 1, period = 8") + ground).empty());
    CHECK_THAT(findings_of(with_wave("height = 1, period = 8", "depth = 30\n") + ground),
               Contains("waves feel the depth 30, and the ground is 12 below the surface"));
    // 3517.21/(5e4 × 0.25) of the diameter.
    CHECK_THAT(findings_of(tube_deck() + water_deck + "[seabed]\nz = -12\nstiffness = 5e4\n"),
               Contains("rod r lies 0.28 of its diameter deep") && Contains("of 1.4e+05 or more"));
}

TEST_CASE("What flows out of the plane of a deck is named", "[check]") {
    const auto push = [](const std::string& lines) {
        return find_push_out_of_plane(read("plane = \"xz\"\n" + tube_deck() + lines).model);
    };
    const auto current = [&](const std::string& keys) {
        return push(water_deck + "current = { " + keys + " }\n");
    };
    CHECK(current("table = [[0, 1]], direction = [1, 0, 0]").empty());
    CHECK_THAT(current("table = [[0, 1]], direction = [1, 1, 0]"), Contains("fluid.current pushes out"));
    CHECK(current("velocity = [1, 0, \"z\"]").empty());
    CHECK_THAT(current("velocity = [1, \"x\", 0]"), Contains("fluid.current pushes out"));
    CHECK_THAT(push("[air]\ndensity = 1\nwind = { velocity = [1, \"t\", 0] }\n"),
               Contains("air.wind pushes out"));
    const std::string wave = "[[wave]]\nairy = { height = 1, period = 8 }\n";
    CHECK(push(water_deck + wave).empty());
    CHECK_THAT(push(water_deck + wave + "direction = [0, 1, 0]\n"), Contains("wave pushes out"));
    const std::string slope = "[seabed]\nstiffness = 1\nplane = { point = [0, 0, -9], normal = ";
    CHECK(push(slope + "[1, 0, 2] }\n").empty());
    CHECK_THAT(push(slope + "[0, 1, 2] }\n"), Contains("seabed pushes out"));
}

}  // namespace gxrod::test
