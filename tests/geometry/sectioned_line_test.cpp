#include "geometry/sectioned_line.hpp"

#include <cmath>

#include "tools/catch.hpp"

namespace gxrod::test {
namespace {

const Vec3 diagonal(0.6, -0.8, 0.0);  // any level direction

SectionedLine::Ends lift(double buoy) {
    SectionedLine::Ends ends{.from = Vec3(1, 2, -40), .to = Vec3(1, 2, -10) + 90 * diagonal};
    ends.stretches = {{.length = 50, .weight = 40, .dry_weight = 60, .compliance = 1e-5},
                      {.length = 60, .weight = 10, .dry_weight = 20, .compliance = 1e-4}};
    if (buoy != 0.0) ends.stretches[0].end_weight = [buoy](double z) { return z < 0.0 ? -buoy : 1e9; };
    ends.bed = -40;
    ends.kink = {.bending = 100, .reach = 1.5};
    return ends;
}

// Gauss' rule of two points in pieces of 1 cm: places follow from tangents and stretch.
Vec3 integrate(const SectionedLine& line, double from, double to, double round) {
    constexpr int pieces = 2000;
    Vec3 sum = Vec3::Zero();
    const double h = (to - from) / pieces, offset = 0.5 * h / std::sqrt(3.0);
    for (int i = 0; i < pieces; ++i) {
        for (const double s : {from + h * (i + 0.5) - offset, from + h * (i + 0.5) + offset}) {
            const double stretch = 1.0 + line.tension(s) * (s < 50 ? 1e-5 : 1e-4);
            sum += 0.5 * h * (std::abs(s - 50) < round ? 1.0 : stretch) * line.tangent(s);
        }
    }
    return sum;
}

}  // namespace

TEST_CASE("A line of two sections goes along its tangents as it stretches", "[geometry]") {
    const SectionedLine line(lift(0.0));
    CHECK(line.length() == 110);
    CHECK(line.position(0) == Vec3(1, 2, -40));
    CHECK(line.position(110) == Vec3(1, 2, -10) + 90 * diagonal);
    for (const auto& [from, to] : {std::pair(0.0, 30.0), {30.0, 50.0}, {50.0, 80.0}, {80.0, 110.0}})
        CHECK((line.position(to) - line.position(from) - integrate(line, from, to, 0.0)).norm() < 1e-6);
    // The level part of the tension is the same everywhere.
    const double level = line.tension(50) * line.tangent(50).dot(diagonal);
    for (const double s : {10.0, 60.0, 105.0})
        CHECK(line.tension(s) * line.tangent(s).dot(diagonal) == Approx(level).epsilon(1e-10));
    CHECK((line.transport(90) * line.tangent(0) - line.tangent(90)).norm() < 1e-14);
    CHECK(line.turn(110) > line.turn(60));
}

TEST_CASE("A line is round at a buoy, and ends where it should", "[geometry]") {
    const SectionedLine line(lift(2000.0));
    CHECK((line.position(110) - line.position(110 - 1e-9)).norm() < 1e-8);
    CHECK((line.tangent(50 - 1e-9) - line.tangent(50 + 1e-9)).norm() < 1e-8);
    CHECK(line.turn(51) - line.turn(49) > 0.5);
    CHECK((line.position(60) - line.position(40) - integrate(line, 40, 60, 0.0)).norm() < 1e-3);
    CHECK((line.position(50) - line.position(49) - integrate(line, 49, 50, 0.0)).norm() < 1e-3);
}

TEST_CASE("An end below the bed is refused", "[geometry]") {
    SectionedLine::Ends ends = lift(0.0);
    ends.bed = -39;
    CHECK_THROWS_WITH(SectionedLine(ends), Catch::Contains("below the bed, z = -39"));
}

}  // namespace gxrod::test
