#include "check/summaries/section_summary.hpp"

#include "model/sections/section_frame.hpp"
#include "tools/catch.hpp"

namespace gxrod::test {
namespace {

using Catch::Contains;

Section make_section(const SectionFrame& frame) {
    Mat6 stiffness = Mat6::Zero();
    stiffness.diagonal() << 100, 40, 30, 5, 6, 7;
    Mat6 mass = Mat6::Zero();
    mass.diagonal() << 2, 2, 2, 0.3, 0.1, 0.2;
    return {.name = "s", .stiffness = move_from(frame, stiffness), .mass = move_from(frame, mass)};
}

Rod make_rod(const std::vector<SectionFrame>& frames) {
    Rod rod;
    for (const SectionFrame& frame : frames) rod.varying.at_nodes.push_back(make_section(frame));
    return rod;
}

}  // namespace

TEST_CASE("a section about its centroid has nothing to say", "[check][sections]") {
    CHECK(describe_centres(make_section({})).empty());
    // Nor one that is turned a quarter.
    CHECK(describe_centres(make_section({0.0, 0.0, 0.5 * M_PI})).empty());
    CHECK(describe_varying_centres(make_rod({{}, {}})).empty());
}

TEST_CASE("centres and axes of a section are said where they are not trivial", "[check][sections]") {
    CHECK(describe_centres(make_section({0.7, -0.3, 0.0})) ==
          "  shear centre at (0.7, -0.3), tension centre at (0.7, -0.3), centre of mass at (0.7, -0.3), "
          "bending stiffness 6 and 7 about y and z, rotary inertia about its centre 0.1 and 0.2 about y and "
          "z\n");
    CHECK(describe_centres(make_section({0.0, 0.0, M_PI / 6.0})) ==
          "  bending stiffness 6 and 7 about y and z turned by 30°, rotary inertia about its centre 0.1 and "
          "0.2 about y and z turned by 30°\n");
}

TEST_CASE("centres along a rod are said at its ends and by their extremes", "[check][sections]") {
    const std::string text =
        describe_varying_centres(make_rod({{}, {0.7, 0.0, 0.0}, {0.1, 0.0, M_PI / 6.0}}));
    CHECK_THAT(text, !Contains("at the start"));
    CHECK_THAT(text, Contains("  at the end: shear centre at (0.1, 0), "));
    CHECK_THAT(text, Contains("  along the rod: shear centre y 0 … 0.7, tension centre y 0 … 0.7, "));
    CHECK_THAT(text, Contains("turn in degrees of the axes of bending 0 … 30"));
}

}  // namespace gxrod::test
