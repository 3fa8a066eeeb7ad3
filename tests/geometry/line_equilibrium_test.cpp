#include "geometry/line_equilibrium.hpp"

#include <algorithm>
#include <cmath>

#include "geometry/hung_line.hpp"
#include "tools/catch.hpp"

namespace gxrod::test {
namespace {

using Catch::Contains;

constexpr double gravity = 9.80665;
const double cable = (25.0 - 1025.0 * M_PI / 4.0 * 0.116 * 0.116) * gravity;
const double modules = (59.0 - 1025.0 * M_PI / 4.0 * 0.361 * 0.361) * gravity;

LineStretch stretch(double length, double weight, double compliance = 0.0) {
    return {.length = length, .weight = weight, .dry_weight = weight, .compliance = compliance};
}

LineStretch ending(LineStretch stretch, double weight) {
    stretch.end_weight = [weight](double) { return weight; };
    return stretch;
}

// How many parts of a line lie on the bed.
int count_lying(const LineEquilibrium& line) {
    int parts = 0;
    for (std::size_t i = 0; i < line.pieces.size(); ++i)
        if (line.pieces[i].lies && (i == 0 || !line.pieces[i - 1].lies)) ++parts;
    return parts;
}

}  // namespace

TEST_CASE("A lazy wave has the tensions of shooting and of MoorPy", "[geometry]") {
    const double compliance = 1.0 / 3.62e8;
    const LineEquilibrium line = find_line_equilibrium({.span = 550,
                                                        .rise = 260,
                                                        .stretches = {stretch(272, cable, compliance),
                                                                      stretch(81.6, modules, compliance),
                                                                      stretch(326.4, cable, compliance)},
                                                        .bed = 0.0});
    // MoorPy 1.3; SciPy's DOP853 has 16622.400133469 and the touch-down at 85.219938263.
    CHECK(line.level == Approx(16622.400133472875).epsilon(1e-10));
    REQUIRE(line.pieces.size() == 4);
    CHECK(line.pieces[0].lies);
    CHECK(line.pieces[1].s == Approx(85.219938263).epsilon(1e-10));
    CHECK(line.pieces[1].upright == 0.0);
    CHECK(std::hypot(line.level, line.pieces[2].upright) == Approx(30817.626628349).epsilon(1e-10));
    CHECK(std::hypot(line.level, line.pieces[3].upright) == Approx(19817.386660255).epsilon(1e-10));
}

TEST_CASE("A line of one section that does not stretch is the catenary", "[geometry]") {
    for (const std::optional<double> bed : {std::optional<double>(), std::optional(-5.0)}) {
        const HungLine exact({Vec3::Zero(), Vec3(100, 0, 20), 120.0, bed});
        const LineEquilibrium line = find_line_equilibrium(
            {.span = 100, .rise = 20, .stretches = {stretch(25, 30), stretch(95, 30)}, .bed = bed});
        CHECK(line.level == Approx(30.0 * exact.level_tension()).epsilon(1e-9));
        CHECK(count_lying(line) == (bed ? 1 : 0));
    }
}

TEST_CASE("A buoy carries half of each side of a line", "[geometry]") {
    const double half = 60.0;
    const LineEquilibrium line = find_line_equilibrium(
        {.span = 100, .rise = 0, .stretches = {ending(stretch(half, 20), -5000), stretch(half, 20)}});
    REQUIRE(line.pieces.size() == 2);
    CHECK(line.pieces[1].x == Approx(50).epsilon(1e-9));
    CHECK(line.pieces[1].upright == Approx(-2500).epsilon(1e-9));
    CHECK(line.pieces[1].kinks);
    CHECK(line.pieces[0].upright == Approx(2500 - 20 * half).epsilon(1e-9));
}

TEST_CASE("A line lies wherever it comes down to the bed", "[geometry]") {
    // Heavy, with a part that floats up in the middle, too long for its ends: on the bed on both sides.
    const LineEquilibrium line = find_line_equilibrium(
        {.span = 180,
         .rise = 30,
         .stretches = {stretch(80, 50, 1e-7), stretch(20, -100, 1e-7), stretch(125, 50, 1e-7)},
         .bed = 0.0});
    REQUIRE(count_lying(line) == 2);
    const auto second = std::find_if(
        line.pieces.begin() + 1, line.pieces.end(), [](const LinePiece& one) { return one.lies; });
    // What floats carries as much of the heavy parts as it lifts: 2000 N, 40 m.
    CHECK(second->z == 0.0);
    CHECK(second->s - line.pieces[1].s == Approx(60.0).epsilon(1e-9));
    CHECK((second + 1)->upright == 0.0);
}

TEST_CASE("What stands out of the water weighs more", "[geometry]") {
    const LineStretch floats{.length = 60, .weight = 10, .dry_weight = 100};
    const LineEquilibrium line =
        find_line_equilibrium({.span = 30, .rise = 50, .stretches = {floats}, .surface = 40.0});
    REQUIRE(line.pieces.size() == 2);
    CHECK(line.pieces[1].z == Approx(40).epsilon(1e-10));
    CHECK(line.pieces[0].weight == 10);
    CHECK(line.pieces[1].weight == 100);
    CHECK(line.pieces[1].upright == Approx(line.pieces[0].upright + 10 * line.pieces[1].s).epsilon(1e-12));
}

TEST_CASE("Lines that are too long or too short are refused", "[geometry]") {
    const auto hang = [](SuspendedLine line) { return find_line_equilibrium(line); };
    CHECK_THROWS_WITH(hang({.span = 10, .rise = 5, .stretches = {stretch(16, 1)}, .bed = 0.0}),
                      Contains("16") && Contains("more than hangs or lies in tension"));
    CHECK_THROWS_WITH(hang({.span = 0, .rise = 5, .stretches = {stretch(6, 1)}}), Contains("more than"));
    CHECK_THROWS_WITH(hang({.span = 10, .rise = 0, .stretches = {stretch(9, 1)}}), Contains("less than"));
    CHECK_THROWS_WITH(hang({.span = 30,
                            .rise = 0,
                            .stretches = {{.length = 40, .weight = -5, .dry_weight = 50, .compliance = 1e-6}},
                            .surface = 0.5}),
                      Contains("float on the surface"));
    // One that stretches reaches.
    CHECK(hang({.span = 10, .rise = 0, .stretches = {stretch(9, 1, 1e-3)}}).level ==
          Approx(111.1).margin(1.0));
}

}  // namespace gxrod::test
