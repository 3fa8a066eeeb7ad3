#include "geometry/hung_line.hpp"

#include <cmath>

#include "geometry/curve_samples.hpp"
#include "tools/catch.hpp"

namespace gxrod::test {
namespace {

using Catch::Contains;

// The equation of a hung line: the slope grows with the arc length by 1/a wherever it is free.
void check_hangs(const HungLine& line) {
    const double a = line.level_tension();
    const auto slope = [&](double s) {
        const Vec3 t = line.tangent(s);
        return t[2] / std::hypot(t[0], t[1]);
    };
    const auto on_bed = line.on_bed();
    const double left = on_bed ? on_bed->from : line.length();
    const double right = on_bed ? on_bed->to : line.length();
    const double most = std::max(std::abs(slope(0.0)), std::abs(slope(line.length()))) + 1e-3;
    for (int i = 0; i < 20; ++i) {
        const double s = left * i / 20.0;
        CHECK((slope(left) - slope(s)) * a == Approx(left - s).margin(1e-14 * most * most * a));
        const double r = right + (line.length() - right) * i / 20.0;
        CHECK((slope(r) - slope(right)) * a == Approx(r - right).margin(1e-14 * most * most * a));
    }
}

// Positions follow from tangents by an integral, from end to end; Gauss' rule of two points in many pieces.
Vec3 integrate_tangent(const HungLine& line, double from, double to) {
    constexpr int pieces = 4000;
    Vec3 sum = Vec3::Zero();
    const double h = (to - from) / pieces, offset = 0.5 * h / std::sqrt(3.0);
    for (int i = 0; i < pieces; ++i) {
        const double middle = from + h * (i + 0.5);
        sum += 0.5 * h * (line.tangent(middle - offset) + line.tangent(middle + offset));
    }
    return sum;
}

const Vec3 diagonal(0.6, -0.8, 0.0);  // any level direction

HungLine hang(double span, double rise, double length, std::optional<double> bed = {}) {
    return HungLine({Vec3(1, 2, 3), Vec3(1, 2, 3) + span * diagonal + rise * Vec3::UnitZ(), length, bed});
}

}  // namespace

TEST_CASE("A hung line has the tensions and the lowest point of the exact catenary", "[geometry]") {
    // Row F1a of the benchmarks: L = 120 from (0, 0) to (100, 20), w = 196.2.
    const HungLine line({Vec3::Zero(), Vec3(100, 0, 20), 120.0, {}});
    const double w = 196.2, level = w * line.level_tension();
    CHECK(level == Approx(9603.43917624285).epsilon(1e-14));
    const double first = line.tangent(0.0)[2] / line.tangent(0.0)[0];
    const double last = line.tangent(120.0)[2] / line.tangent(120.0)[0];
    CHECK(-level * first == Approx(9225.53699635976).epsilon(1e-14));
    CHECK(level * last == Approx(14318.4630036402).epsilon(1e-14));
    CHECK(level * std::hypot(1.0, first) == Approx(13316.7780218414).epsilon(1e-14));
    CHECK(level * std::hypot(1.0, last) == Approx(17240.7780218414).epsilon(1e-14));
    const Vec3 lowest = line.position(-first * line.level_tension());
    CHECK((lowest - Vec3(41.7653143249587, 0, -18.9262938103903)).norm() < 1e-12);
    CHECK_FALSE(line.on_bed());
}

TEST_CASE("A hung line on a bed touches down where the exact one does", "[geometry]") {
    // Row F2a of the benchmarks without friction: anchor (0, 0), fairlead (400, 200), L = 500, w = 800. Its
    // stretch, by EA = 7.51e12, changes the seventh digit; without it, of mpmath's root of the two equations
    // of the ends:
    const HungLine line({Vec3::Zero(), Vec3(400, 0, 200), 500.0, 0.0});
    const double level = 800.0 * line.level_tension();
    REQUIRE(line.on_bed());
    CHECK(line.on_bed()->from == 0.0);
    CHECK(line.on_bed()->to == Approx(202.810262318529055).epsilon(1e-14));
    CHECK(line.on_bed()->to == Approx(202.810289957253).epsilon(2e-7));
    CHECK(level == Approx(96643.4803663630228).epsilon(1e-14));
    CHECK(level == Approx(96643.4535471202).epsilon(4e-7));
    const Vec3 top = line.tangent(500.0);
    CHECK(level * top[2] / top[0] == Approx(237751.790145176756).epsilon(1e-14));
    CHECK(line.tangent(100.0) == Vec3::UnitX());
    CHECK(line.position(100.0) == Vec3(100, 0, 0));
}

TEST_CASE("Hung lines are curves by arc length, obey their equation and end where they must", "[geometry]") {
    struct Ends {
        double span, rise, length;
        std::optional<double> bed;
    };
    for (const Ends& ends : {Ends{100, 20, 120, {}},
                             Ends{100, -20, 120, {}},
                             Ends{100, 0, 300, {}},
                             Ends{10, 200, 230, {}},
                             Ends{100, 20, 102.5, {}},
                             Ends{400, 200, 500, 3.0},
                             Ends{400, -200, 500, -197.0},
                             Ends{300, 80, 370, -20.0},
                             Ends{300, 0, 320, -10.0},
                             Ends{300, 10, 350, -50.0}}) {
        INFO(ends.span << " " << ends.rise << " " << ends.length);
        const HungLine line = hang(ends.span, ends.rise, ends.length, ends.bed);
        check_curve(line);
        check_hangs(line);
        const Vec3 start(1, 2, 3), end = start + ends.span * diagonal + ends.rise * Vec3::UnitZ();
        CHECK(line.position(0.0) == start);
        CHECK(line.position(ends.length) == end);
        const double before_end = ends.length * (1.0 - 1e-15);
        CHECK((line.position(before_end) - end).norm() < 2e-13 * ends.length);
        CHECK((line.position(1e-15 * ends.length) - start).norm() < 2e-13 * ends.length);
        const double turn = line.turn(ends.length);
        CHECK(std::cos(turn) == Approx(line.tangent(0.0).dot(line.tangent(ends.length))).margin(1e-14));
    }
}

TEST_CASE("A line on the bed stays on it, level, between two risers", "[geometry]") {
    const HungLine line = hang(300, 80, 370, -20.0);
    REQUIRE(line.on_bed());
    const auto [from, to] = *line.on_bed();
    CHECK(from > 23.0);
    CHECK(to > from);
    const Vec3 first = line.position(from), last = line.position(to);
    CHECK(first[2] == -20.0);
    CHECK(last[2] == -20.0);
    CHECK((last - first - (to - from) * diagonal).norm() < 1e-12);
    for (const double part : {0.3, 0.7}) CHECK(line.tangent(from + part * (to - from)) == diagonal);
    // Both risers have one level tension: s² = h (h + 2a).
    const double a = line.level_tension();
    CHECK(from * from == Approx(23.0 * (23.0 + 2.0 * a)).epsilon(1e-13));
    CHECK((370 - to) * (370 - to) == Approx(103.0 * (103.0 + 2.0 * a)).epsilon(1e-13));
    CHECK((integrate_tangent(line, 0, from) + (last - first) + integrate_tangent(line, to, 370) -
           Vec3(0.6 * 300, -0.8 * 300, 80))
              .norm() < 1e-8);
}

TEST_CASE("A bed that a line just does not reach does not change it", "[geometry]") {
    const HungLine free_line = hang(100, 20, 120);
    const double lowest = 3.0 - 18.9262938103903;
    const HungLine above = hang(100, 20, 120, lowest - 1e-9);
    CHECK_FALSE(above.on_bed());
    CHECK(above.level_tension() == free_line.level_tension());
    const HungLine touching = hang(100, 20, 120, lowest + 1e-9);
    REQUIRE(touching.on_bed());
    CHECK(touching.on_bed()->to - touching.on_bed()->from < 1e-3);
    CHECK(touching.level_tension() == Approx(free_line.level_tension()).epsilon(1e-7));
    for (const double s : {20.0, 60.0, 110.0}) {
        CHECK((touching.position(s) - free_line.position(s)).norm() < 1e-7);
    }
}

TEST_CASE("Nearly taut lines keep their digits", "[geometry]") {
    // Of small sag: f = span c/(8a) below the middle of the chord c, across which the middle of the line
    // moves. The length exceeds it by Δ = span⁴/(24 a² c) and terms of higher order.
    for (const double surplus : {1e-3, 1e-6, 1e-9, 1e-12}) {
        INFO(surplus);
        const double chord = std::hypot(100.0, 20.0);
        const HungLine line = hang(100, 20, chord * (1.0 + surplus));
        const double real_surplus = line.length() - chord;
        const double a = std::sqrt(1e8 / (24.0 * chord * real_surplus));
        CHECK(line.level_tension() == Approx(a).epsilon(2.0 * surplus + 1e-13));
        const double sag = 100.0 * chord / (8.0 * a);
        const Vec3 middle(1 + 30, 2 - 40, 3 + 10);
        const Vec3 below = line.position(0.5 * line.length()) - middle;
        CHECK(below[2] == Approx(-sag / 1.04).epsilon(2.0 * surplus + 2e-9));
        CHECK((integrate_tangent(line, 0, line.length()) - Vec3(60, -80, 20)).norm() < 1e-12 * chord);
    }
    const HungLine taut = hang(3, 4, 5);
    CHECK((taut.tangent(1.0) - Vec3(0.36, -0.48, 0.8)).norm() < 1e-15);
    CHECK(std::isinf(taut.level_tension()));
    CHECK((taut.position(2.5) - Vec3(1.9, 0.8, 5)).norm() < 1e-15);
    CHECK(taut.turn(4.0) == 0.0);
}

TEST_CASE("Nearly upright lines keep their digits", "[geometry]") {
    for (const double span : {1.0, 1e-3, 1e-6, 1e-9}) {
        INFO(span);
        const HungLine line = hang(span, 20, 60);
        // Down by (60 − 20)/2 but for the small bottom, of a's order.
        const double a = line.level_tension();
        CHECK(a < span);
        const Vec3 before_end = line.position(60 * (1 - 1e-15));
        CHECK((before_end - (Vec3(1, 2, 23) + span * diagonal)).norm() < 1e-12);
        CHECK(line.position(20.0)[2] == Approx(3 - 20).margin(2.0 * a));
        CHECK((line.position(30.0) - (Vec3(1, 2, 3 - 10) + span * diagonal)).norm() < 60 * a);
    }
    // Straight up.
    const HungLine pole({Vec3(1, 2, 3), Vec3(1, 2, 13), 10.0, 3.0});
    CHECK(pole.tangent(5.0) == Vec3::UnitZ());
    CHECK(pole.position(4.0) == Vec3(1, 2, 7));
}

TEST_CASE("Lines with an end on the bed lie on it up to where they rise", "[geometry]") {
    // Hardly any tension, and hardly any bed left.
    for (const double length : {300.0 + 100.0 - 1e-3, 330.0, 321.177104}) {
        INFO(length);
        const HungLine line = hang(300, 100, length, 3.0);
        REQUIRE(line.on_bed());
        CHECK(line.on_bed()->from == 0.0);
        CHECK((integrate_tangent(line, 0, line.on_bed()->to) +
               integrate_tangent(line, line.on_bed()->to, length) - Vec3(180, -240, 100))
                  .norm() < 1e-2 * (length > 399.0) + 1e-8);
        check_hangs(line);
    }
    // Of length 321.1771035887122559 a line (a = 465.77365934817) just rises from its end.
    CHECK(hang(300, 100, 321.1771035887122559, 3.0).level_tension() ==
          Approx(465.77365934817202).epsilon(1e-12));
    CHECK_FALSE(hang(300, 100, 321.177103, 3.0).on_bed());
    // Hardly any slack: L − X = √(2h³/a)/3.
    const double slack = 300.00000001 - 300.0;
    const HungLine taut = hang(300, 1e-3, 300.00000001, 3.0);
    REQUIRE(taut.on_bed());
    CHECK(taut.level_tension() == Approx(2e-9 / (9.0 * slack * slack)).epsilon(2e-5));
    // Both ends on the bed, straight.
    const HungLine flat = hang(300, 0, 300, 3.0);
    CHECK(flat.tangent(0.0) == diagonal);
}

TEST_CASE("A line that cannot hang says why, with its numbers", "[geometry]") {
    CHECK_THROWS_WITH(hang(3, 4, 4.9), Contains("4.9") && Contains("less than the distance of its ends, 5"));
    CHECK_THROWS_WITH(hang(3, 4, std::nan("")), Contains("less than the distance"));
    CHECK_THROWS_WITH(hang(0, 4, 5.0), Contains("above each other") && Contains("hang double"));
    CHECK_THROWS_WITH(hang(300, 100, 400.5, 3.0),
                      Contains("400.5") && Contains("400:") && Contains("loosely"));
    CHECK_THROWS_WITH(hang(300, 0, 301.0, 3.0), Contains("loosely"));
    CHECK_THROWS_WITH(hang(300, 100, 350.0, 4.0), Contains("below the bed, z = 4"));
    CHECK_THROWS_AS(HungLine({Vec3::Zero(), Vec3::Zero(), 0.0, {}}), std::invalid_argument);
}

}  // namespace gxrod::test
