#include <string>

#include "cross_section/walls/sample_walls.hpp"
#include "tools/catch.hpp"

using namespace gxrod;

namespace {

const std::vector<Layup> layups{{"skin", {{0, 0.1, 0.0}, {0, 0.2, 0.0}}}, {"web", {{0, 0.5, 0.0}}}};

std::string describe(const std::optional<WallFault>& fault) {
    return fault ? fault->part + ": " + fault->message : "";
}

std::string fault_of(const WallOutline& outline) { return describe(find_fault(outline, layups)); }

// A rectangle 4 × 2 around (0, 0).
WallOutline make_frame() {
    return {.corners = {{{-2, -1}}, {{2, -1}}, {{2, 1}}, {{-2, 1}}},
            .is_closed = true,
            .line = WallSide::right,
            .layups = {0}};
}

}  // namespace

TEST_CASE("Layups without thickness are refused", "[cross_section]") {
    CHECK(describe(find_fault(layups[0])).empty());
    CHECK(describe(find_fault(Layup{"skin", {}})) == "plies: expected one at least");
    CHECK(describe(find_fault(Layup{"skin", {{0, 0.1, 0.0}, {0, 0.0, 0.0}}})) ==
          "plies[1]: thickness is zero");
    CHECK(describe(find_fault(Layup{"skin", {{0, -0.1, 0.0}}})) ==
          "plies[0]: thickness is -0.1; expected more than 0");
}

TEST_CASE("Walls with missing or misplaced corners are refused", "[cross_section]") {
    WallOutline outline = make_frame();
    CHECK(fault_of(outline).empty());
    outline.layups = {0, 0, 0};
    CHECK(fault_of(outline) == "layups: expected one for each of the 4 sides, found 3");
    outline.layups = {0};
    outline.corners = {{{0, 0}}, {{1, 0}}};
    CHECK(fault_of(outline) == "corners: expected 3 at least in a closed wall, found 2");
    outline.is_closed = false;
    CHECK(fault_of(outline).empty());
    outline.corners.pop_back();
    CHECK(fault_of(outline) == "corners: expected 2 at least in an open wall, found 1");
    outline = make_frame();
    outline.corners[3] = outline.corners[2];
    CHECK(fault_of(outline) == "corners[3]: is at the same place as corners[2]");
    outline = make_frame();
    std::swap(outline.corners[1], outline.corners[3]);
    CHECK(fault_of(outline) ==
          "corners: go clockwise; a closed wall is walked anticlockwise, as seen with y to the right and z "
          "up, and "
          "its plies are listed from outside in: reverse the corners");
    outline.corners = {{{0, 0}}, {{4, 4}}, {{4, 0}}, {{0, 4}}};
    CHECK(fault_of(outline) == "corners: sides 0 and 2 cross at (2, 2)");
}

TEST_CASE("Walls whose corners do not work are refused", "[cross_section]") {
    WallOutline outline{.corners = {{{0, 0}}, {{4, 0}}, {{1, 0}}}, .line = WallSide::middle, .layups = {0}};
    CHECK(fault_of(outline) == "corners[1]: the wall turns back on itself");
    outline.corners[2].at = {8, 0};
    outline.layups = {0, 1};
    CHECK(
        fault_of(outline) ==
        "corners[1]: the sides before and after it are 0.3 and 0.5 thick; walls of two thicknesses meet at a "
        "corner without radius only");
    outline.corners[2].at = {4, 4};
    CHECK(fault_of(outline).empty());
    outline.corners[1].radius = 1.0;
    CHECK(
        fault_of(outline) ==
        "corners[1]: the sides before and after it are 0.3 and 0.5 thick; walls of two thicknesses meet at a "
        "corner without radius only");
    outline.layups = {0};
    CHECK(fault_of(outline).empty());
    outline.corners[1].radius = 0.15;
    CHECK(fault_of(outline) ==
          "corners[1]: radius 0.15 leaves no radius on the inner side of the wall; expected more than 0.15, "
          "or 0 "
          "for a mitre");
}

TEST_CASE("Sides that are too short for their corners are refused", "[cross_section]") {
    WallOutline outline = make_frame();
    outline.layups = {1};
    outline.corners[2].at.y() = outline.corners[3].at.y() = 0.0;
    CHECK(fault_of(outline) ==
          "corners: side 1 from corners[1] to corners[2] is 1 long, shorter than its mitres, which take 1");
    outline = make_frame();
    for (WallCorner& corner : outline.corners) corner.radius = 1.5;
    CHECK(fault_of(outline) ==
          "corners: side 1 from corners[1] to corners[2] is 2 long, shorter than the arcs and mitres at its "
          "ends, "
          "which take 3");
    // The arcs may take a side whole.
    for (WallCorner& corner : outline.corners) corner.radius = 1.0;
    CHECK(fault_of(outline).empty());
}

TEST_CASE("Walls that overlap are refused, with where", "[cross_section]") {
    WallOutline hook{.corners = {{{0, 0}}, {{4, 0}}, {{4, 2}}, {{2, 2}}, {{2, -2}}}, .layups = {0}};
    CHECK(fault_of(hook) == "corners: the walls of sides 0 and 3 overlap near (1.85, -0.15)");
    hook.corners[4].at = {2.0, 0.16};
    CHECK(fault_of(hook).empty());
    hook.corners[4].at = {2.0, 0.14};
    CHECK(fault_of(hook) == "corners: the walls of sides 0 and 3 overlap near (1.85, 0.15)");
}

TEST_CASE("A ply thicker than its wall is long is taken for a mistaken unit", "[cross_section]") {
    WallOutline outline{.corners = {{{0, 0}}, {{0.02, 0}}, {{0.02, 0.01}}}, .layups = {0}};
    CHECK(describe(find_fault(outline, {{"skin", {{0, 0.01, 0.0}, {0, 0.125, 0.0}}}})) ==
          "layup: a ply of \"skin\" is 0.125 thick in a wall whose longest side is 0.02: are both in one "
          "unit?");
}
