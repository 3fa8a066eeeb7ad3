#include "deck/sections/shapes/profile_outline.hpp"

#include "cross_section/cross_section.hpp"
#include "deck/decks.hpp"
#include "tools/catch.hpp"

namespace gxrod::test {
namespace {

using Catch::Contains;

// The shape in line 2, from column 11.
std::string with_shape(const std::string& shape, const std::string& units = "") {
    return units + "[section.s]\nshape = { " + shape + R"( }
material = { E = 210e3, nu = 0.3 }
[rod.r]
section = "s"
line = { from = [0, 0, 0], to = [1000, 0, 0] }
elements = 2
[analysis]
kind = "static"
)";
}

constexpr const char* in_mm = "units = \"mm, N\"\n";

double area_of(const std::string& deck) {
    const Problem problem = read(deck);
    REQUIRE(problem.model.sections[0].shape);
    return problem.model.sections[0].shape->properties.area;
}

}  // namespace

TEST_CASE("a profile has the deck's unit of length, by units or by millimetre", "[deck][sections]") {
    const double area = 2848.4107;
    for (const auto& [units, mm] : {std::pair("mm N", 1.0),
                                    {"m kg s", 1e-3},
                                    {"cm, kN", 0.1},
                                    {"in lbf", 1 / 25.4},
                                    {"ft; kip", 1 / 304.8},
                                    {"N mm s", 1.0},
                                    {"kg m s", 1e-3}}) {
        INFO(units);
        const std::string line = std::string("units = \"") + units + "\"\n";
        CHECK(area_of(with_shape("profile = \"IPE 200\"", line)) == Approx(area * mm * mm).epsilon(2e-6));
    }
    CHECK(area_of(with_shape("profile = \"IPE 200\", millimetre = 0.1", in_mm)) ==
          Approx(0.01 * area).epsilon(2e-6));
    // American profiles are in inches.
    CHECK(area_of(with_shape("profile = \"W14x90\"", in_mm)) == Approx(26.5 * 645.16).epsilon(3e-3));
}

TEST_CASE("a profile that there is not, or without a unit, is refused", "[deck][sections]") {
    CHECK_THAT(faults_of(with_shape("profile = \"IPE 205\"", in_mm)),
               Contains("x.toml:3:21: section.s.shape.profile: no profile \"IPE 205\"; nearest are IPE 200, "
                        "IPE 220"));
    CHECK_THAT(faults_of(with_shape("profile = \"SHS 100x5\"", in_mm)),
               Contains("no profile \"SHS 100x5\"; nearest are SHS 100x100x5 cold, SHS 100x100x5 hot"));
    CHECK_THAT(
        faults_of(with_shape("profile = \"IPX 200\"", in_mm)),
        Contains("no profile \"IPX 200\"; the series are CHS, HD, HEA, HEB, HEM, HP, HSS, IPE, L, RHS, "
                 "SHS, UPE, UPN, W"));
    const std::string missing = "section.s.shape.millimetre: missing; units = \"{}\" does not say a length";
    CHECK_THAT(faults_of(with_shape("profile = \"IPE 200\"", "units = \"kN\"\n")),
               Contains(replaced(missing, "{}", "kN")));
    CHECK_THAT(faults_of(with_shape("profile = \"IPE 200\"", "units = \"kN m, mm\"\n")),
               Contains(replaced(missing, "{}", "kN m, mm")));
    CHECK_THAT(faults_of(with_shape("profile = \"IPE 200\"")), Contains(replaced(missing, "{}", "")));
    CHECK_THAT(faults_of(with_shape("profile = \"IPE 200\", millimetre = 0", in_mm)),
               Contains("section.s.shape.millimetre: expected a number greater than 0"));
}

TEST_CASE("profiles by their numbers have the area of the shape", "[deck][sections]") {
    CHECK(area_of(with_shape("I = { height = 200, width = 100, web = 5.6, flange = 8.5, fillet = 12 }")) ==
          Approx(2848.4107).epsilon(2e-6));
    CHECK(area_of(with_shape("channel = { height = 140, width = 60, web = 7, flange = 10, fillet = 10, "
                             "toe = 5, slope = 0.08 }")) == Approx(2036.9768).epsilon(2e-6));
    CHECK(area_of(with_shape("angle = { height = 100, width = 100, wall = 10, fillet = 12, toe = 6 }")) ==
          Approx(1915.4513).epsilon(2e-6));
    CHECK(area_of(with_shape("tee = { height = 100, width = 100, web = 10, flange = 10, fillet = 8 }")) ==
          Approx(1927.4690).epsilon(2e-6));
    // The inner radius follows from the outer one.
    CHECK(area_of(with_shape("box = { height = 100, width = 100, wall = 5, outer_radius = 10 }")) ==
          Approx(1835.6194).epsilon(2e-6));
    CHECK(area_of(with_shape("box = { height = 100, width = 50, wall = 5, flange = 10 }")) ==
          Approx(5000 - 40 * 80).epsilon(1e-9));
    CHECK(area_of(with_shape("zed = { height = 100, width = 40, wall = 2 }")) == Approx(352).epsilon(1e-9));
    CHECK(area_of(with_shape("hat = { height = 60, width = 50, foot = 20, wall = 3, radius = 3 }")) ==
          Approx(588.82300).epsilon(2e-6));
}

TEST_CASE("numbers of a profile that do not go together are named with their place", "[deck][sections]") {
    CHECK_THAT(faults_of(with_shape("I = { height = 200, width = 100, web = 5.6, flange = 120 }")),
               Contains("x.toml:2:64: section.s.shape.I.flange: 120 is more than half the height 200"));
    CHECK_THAT(faults_of(with_shape("box = { height = 100, width = 100, wall = 5, flange = 50 }")),
               Contains("section.s.shape.box.flange: 50 is half the height 100"));
    CHECK_THAT(
        faults_of(with_shape("tee = { height = 100, width = 100, web = 10, flange = 10, fillet = 46 }")),
        Contains("section.s.shape.tee.fillet: 46 does not fit; expected at most 45"));
    // Along a rod the message says where.
    CHECK_THAT(
        faults_of(with_shape("I = { height = \"200 - 0.19*s\", width = 100, web = 5.6, flange = 8.5 }")),
        Contains("section.s.shape.I.flange: 8.5 is more than half the height 10 at s = 1000 of rod.r"));
    // One fault, not a second one for the shape that follows from it.
    const std::string negative =
        faults_of(with_shape("I = { height = -1, width = 100, web = 5, flange = 8 }"));
    CHECK_THAT(negative, Contains("section.s.shape.I.height: expected a number greater than 0"));
    CHECK_THAT(negative, !Contains("flange"));
}

TEST_CASE("a polygon has holes and rounded corners", "[deck][sections]") {
    const std::string outer = "outer = [[0, 0], [80, 0, 4], [80, 40, 4], [0, 40]]";
    const std::string hole = "holes = [[[3, 3], [77, 3], [77, 37], [3, 37]]]";
    const double rounding = (1 - M_PI / 4) * 16;
    CHECK(area_of(with_shape("polygon = { " + outer + " }")) == Approx(3200 - 2 * rounding).epsilon(1e-6));
    CHECK(area_of(with_shape("polygon = { " + outer + ", " + hole + " }")) ==
          Approx(3200 - 2 * rounding - 74 * 34).epsilon(1e-5));
}

TEST_CASE("what is wrong with a polygon has the place of the corner", "[deck][sections]") {
    CHECK_THAT(
        faults_of(with_shape("polygon = { outer = [[0, 0], [2, 2], [2, 0], [0, 2]] }")),
        Contains("x.toml:2:32: section.s.shape.polygon.outer[0]: the side from corner 0 to 1 and the side "
                 "from corner 2 to 3 cross or touch at (1, 1)"));
    CHECK_THAT(faults_of(with_shape("polygon = { outer = [[0, 0], [9, 0], [9, 9, 5], [0, 9, 5]] }")),
               Contains("x.toml:2:59: section.s.shape.polygon.outer[3]: radius 5 does not fit"));
    CHECK_THAT(
        faults_of(with_shape("polygon = { outer = [[0, 0], [9, 0]] }")),
        Contains("x.toml:2:31: section.s.shape.polygon.outer: expected three corners or more, found 2"));
    CHECK_THAT(faults_of(with_shape("polygon = { outer = [[0, 0], [9, 0], [0, 9]], holes = [[[1, 1], [2, 1], "
                                    "[1, 12]]] }")),
               Contains("section.s.shape.polygon.holes[0]: touches the outline at"));
    CHECK_THAT(
        faults_of(with_shape("polygon = { outer = [[0, 0], [9, 0], [0, 9, 1, 2]] }")),
        Contains("section.s.shape.polygon.outer[2]: expected a corner [y, z] or [y, z, radius], found"));
    CHECK_THAT(faults_of(with_shape("polygon = { outer = [[0, 0], [9, 0], [0, 9, -1]] }")),
               Contains("section.s.shape.polygon.outer[2][2]: expected a number at least 0"));
    CHECK_THAT(
        faults_of(with_shape("polygon = { outer = 3 }")),
        Contains("section.s.shape.polygon.outer: expected an array of corners [y, z] or [y, z, radius], "
                 "two at least, found"));
    CHECK_THAT(faults_of(with_shape("polygon = { outer = [[0, 0], [9, 0], [0, 9]], holes = 3 }")),
               Contains("section.s.shape.polygon.holes: expected an array of arrays of corners"));
}

TEST_CASE("origin is refused where a shape has none", "[deck][sections]") {
    CHECK_THAT(faults_of(with_shape("circle = { radius = 3 }, origin = \"centroid\"")),
               Contains("x.toml:2:45: section.s.shape.origin: goes with profiles and polygons"));
    CHECK_THAT(faults_of(with_shape("circle = { radius = 3 }, millimetre = 1")),
               Contains("section.s.shape.millimetre: goes with profile"));
}

TEST_CASE("the rod is at the origin of a polygon, and at the centroid of a profile", "[deck][sections]") {
    const auto centroid_of = [](const std::string& shape) {
        return read(with_shape(shape)).model.sections[0].shape->properties.centroid;
    };
    const std::string polygon = "polygon = { outer = [[10, 0], [30, 0], [30, 40], [10, 40]] }";
    const std::string angle = "angle = { height = 100, width = 100, wall = 10, fillet = 12, toe = 6 }";
    CHECK((centroid_of(polygon) - PlanePoint(20, 20)).norm() < 1e-9);
    CHECK(centroid_of(polygon + ", origin = \"centroid\"").norm() < 1e-9);
    CHECK(centroid_of(angle).norm() < 1e-4);
    CHECK((centroid_of(angle + ", origin = \"given\"") - PlanePoint(28.22455, 28.22455)).norm() < 1e-4);
    CHECK((centroid_of(angle + ", origin = \"shear centre\"") - PlanePoint(22.330797, 22.330797)).norm() <
          1e-3);
}

}  // namespace gxrod::test
