#include "check/findings/shape_findings.hpp"

#include <fmt/format.h>

#include "deck/decks.hpp"
#include "tools/catch.hpp"

namespace gxrod::test {
namespace {

std::string notes_on(const std::string& deck) {
    std::string all;
    for (const Finding& finding : question_shapes(read(deck).model)) all += finding.message + "\n";
    return all;
}

// A strip that is bent to a quarter of a circle across its height.
std::string arc_deck(double height, double radius) {
    return fmt::format(
        "[section.s]\nshape = {{ rectangle = {{ width_y = 1e-3, height_z = {} }} }}\nmaterial = {{ E = 2e11, "
        "nu = 0.3 }}\n"
        "[rod.r]\nsection = \"s\"\narc = {{ centre = [0, 0, 0], axis = [0, 1, 0], from = [{}, 0, 0], angle = "
        "\"pi/2\" }}\nelements = 9\n"
        "[analysis]\nkind = \"static\"\n[output]\nstresses = \"von-mises\"\n",
        height,
        radius);
}

}  // namespace

TEST_CASE("How much less a rod twists whose warping is held is that of benchmark X30", "[check]") {
    struct Reference {
        double length, twist;  // over that of free warping
    };
    for (const Reference& one : {Reference{1, 0.378591}, {2, 0.654335}, {5, 0.860851}, {10, 0.930425}}) {
        CAPTURE(one.length);
        const std::string notes =
            notes_on(fmt::format("units = \"m N\"\n[section.s]\nshape = {{ profile = \"IPE 200\" "
                                 "}}\nmaterial = {{ E = 210e9, nu = 0.3 }}\n"
                                 "[rod.r]\nsection = \"s\"\nline = {{ from = [0, 0, 0], to = [{}, 0, 0] "
                                 "}}\nelements = 2\ny_axis = [0, 1, 0]\n"
                                 "[analysis]\nkind = \"static\"\n",
                                 one.length));
        CHECK(notes ==
              fmt::format("rod r: where the warping of IPE 200 is held, as at a clamp, this reaches 0.696 "
                          "along the rod, which is {} long; held at one end it twists {:.0f} % less than "
                          "computed\n",
                          one.length,
                          100.0 * (1.0 - one.twist)));
    }
}

TEST_CASE("A section that is large compared with the radius of its rod is noted", "[check]") {
    // Benchmark X31: at h/R = 0.1 the inner stress is 3.4 % larger, and bending pulls by -EI/R.
    CHECK(notes_on(arc_deck(0.1, 1.0)) ==
          "rod r: its section is 0.1 of the radius of curvature; coupling and stress of that order are left "
          "out\n");
    CHECK(notes_on(arc_deck(0.2, 1.0)) ==
          "rod r: its section is 0.2 of the radius of curvature; coupling and stress of that order are left "
          "out\n");
    CHECK(notes_on(arc_deck(0.2, 5.0)).empty());
}

}  // namespace gxrod::test
