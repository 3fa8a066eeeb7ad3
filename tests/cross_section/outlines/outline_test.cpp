#include "cross_section/outlines/outline.hpp"

#include <numbers>

#include "cross_section/outlines/outline_contact.hpp"
#include "cross_section/outlines/outline_examination.hpp"
#include "cross_section/outlines/outline_moments.hpp"
#include "tools/catch.hpp"

namespace gxrod::test {
namespace {

constexpr double pi = std::numbers::pi;

CornerChain rectangle(double y0, double z0, double y1, double z1, double radius = 0.0) {
    return {{{y0, z0}, radius}, {{y1, z0}, radius}, {{y1, z1}, radius}, {{y0, z1}, radius}};
}

std::string fault_of(const Polygon& polygon) {
    const auto fault = find_fault(polygon);
    return fault ? fault->part + ": " + fault->message : "";
}

}  // namespace

TEST_CASE("Moments of a triangle and of a rectangle with a hole are the closed forms", "[cross_section]") {
    const double b = 3.0, h = 2.0;
    const OutlineMoments triangle = compute_moments(draw_outline({{{{1, 1}}, {{1 + b, 1}}, {{1, 1 + h}}}}));
    CHECK(triangle.area == Approx(b * h / 2).epsilon(1e-14));
    CHECK(triangle.centroid.x() == Approx(1 + b / 3).epsilon(1e-14));
    CHECK(triangle.centroid.y() == Approx(1 + h / 3).epsilon(1e-14));
    CHECK(triangle.Iy == Approx(b * h * h * h / 36).epsilon(1e-14));
    CHECK(triangle.Iz == Approx(h * b * b * b / 36).epsilon(1e-14));
    CHECK(triangle.Iyz == Approx(-b * b * h * h / 72).epsilon(1e-14));

    const OutlineMoments frame =
        compute_moments(draw_outline({rectangle(0, 0, 4, 6), {rectangle(1, 1, 3, 5)}}));
    CHECK(frame.area == Approx(16.0).epsilon(1e-14));
    CHECK(frame.Iy == Approx((4.0 * 216 - 2.0 * 64) / 12).epsilon(1e-14));
    CHECK(frame.Iz == Approx((6.0 * 64 - 4.0 * 8) / 12).epsilon(1e-14));
    CHECK(std::abs(frame.Iyz) < 1e-14 * frame.Iy);
}

TEST_CASE("Moments of arcs are exact: a ring, and a square rounded to a circle", "[cross_section]") {
    const OutlineMoments ring = compute_moments(move_outline(draw_ring(0.1, 0.09), {5.0, -3.0}));
    CHECK(ring.area == Approx(pi * (0.01 - 0.0081)).epsilon(1e-13));
    CHECK(ring.Iy == Approx(pi / 4 * (1e-4 - std::pow(0.09, 4))).epsilon(1e-13));
    CHECK(ring.Iz == Approx(ring.Iy).epsilon(1e-13));
    CHECK(ring.centroid.x() == Approx(5.0));
    CHECK(ring.centroid.y() == Approx(-3.0));

    const Outline circle = draw_outline({rectangle(-1, -1, 1, 1, 1.0)});
    CHECK(circle.outer.size() == 4);
    CHECK(compute_moments(circle).area == Approx(pi).epsilon(1e-14));
    CHECK(compute_moments(circle).Iy == Approx(pi / 4).epsilon(1e-13));
}

TEST_CASE("A rounded corner takes (1 − π/4) r² from a right angle, or adds it", "[cross_section]") {
    const double r = 0.3, piece = (1 - pi / 4) * r * r;
    CornerChain angle = {{{0, 0}}, {{3, 0}}, {{3, 1}}, {{1, 1}}, {{1, 3}}, {{0, 3}}};
    CHECK(compute_moments(draw_outline({angle})).area == Approx(5.0).epsilon(1e-14));
    angle[3].radius = r;
    CHECK(compute_moments(draw_outline({angle})).area == Approx(5.0 + piece).epsilon(1e-14));
    angle[1].radius = r;
    CHECK(compute_moments(draw_outline({angle})).area == Approx(5.0).epsilon(1e-14));
    angle[2].radius = 0.5 * r;
    CHECK(compute_moments(draw_outline({angle})).area == Approx(5.0 - 0.25 * piece).epsilon(1e-14));
}

TEST_CASE("Chains in either direction draw the same area, to the left of every loop", "[cross_section]") {
    Polygon polygon{rectangle(0, 0, 4, 6, 0.5), {rectangle(1, 1, 3, 5, 0.25)}};
    const OutlineMoments one = compute_moments(draw_outline(polygon));
    std::ranges::reverse(polygon.outer);
    std::ranges::reverse(polygon.holes[0]);
    const OutlineMoments other = compute_moments(draw_outline(polygon));
    CHECK(one.area > 0.0);
    CHECK(other.area == Approx(one.area).epsilon(1e-14));
    CHECK(other.Iz == Approx(one.Iz).epsilon(1e-14));
}

TEST_CASE("A point between an arc and its chord is inside", "[cross_section]") {
    const Outline ring = draw_ring(1.0, 0.9);
    const PlanePoint near_edge(0.999 * std::cos(0.7), 0.999 * std::sin(0.7));
    CHECK(is_inside(ring.outer, near_edge));
    CHECK_FALSE(is_inside(ring.outer, 1.01 * near_edge));
    CHECK(is_inside(ring.holes[0], {0.0, 0.899}));
    CHECK_FALSE(is_inside(ring.holes[0], near_edge));
}

TEST_CASE("Polygons without a fault have none", "[cross_section]") {
    CHECK(fault_of({rectangle(0, 0, 4, 6)}).empty());
    CHECK(fault_of({rectangle(-1, -1, 1, 1, 1.0)}).empty());
    CHECK(fault_of({rectangle(0, 0, 4, 6), {rectangle(1, 1, 3, 2), rectangle(1, 3, 3, 5, 0.2)}}).empty());
    // A corner without a turn, with a radius.
    CHECK(fault_of({{{{0, 0}}, {{1, 0}, 0.7}, {{2, 0}}, {{2, 1}}, {{0, 1}}}}).empty());
    // A hole that the rounding alone leaves free.
    CHECK(fault_of({rectangle(0, 0, 4, 4, 0.1), {{{{3.9, 3.9}}, {{1, 3}}, {{3, 1}}}}}).empty());
}

TEST_CASE("Too few and repeated corners are named", "[cross_section]") {
    CHECK(fault_of({{{{0, 0}}, {{1, 0}}}}) == "outer: expected three corners or more, found 2");
    CHECK(fault_of({}) == "outer: expected three corners or more, found 0");
    CHECK(fault_of({rectangle(0, 0, 4, 6), {{{{1, 1}}}}}) ==
          "holes[0]: expected three corners or more, found 1");
    CHECK(fault_of({{{{0, 0}}, {{1, 0}}, {{1, 0}}, {{0, 1}}}}) == "outer[2]: repeats corner 1");
    CHECK(fault_of({{{{0, 0}}, {{1, 0}}, {{0, 1}}, {{0, 0}}}}) ==
          "outer[3]: repeats corner 0; the last side goes back to the first corner by itself");
}

TEST_CASE("A radius that does not fit is named with the side", "[cross_section]") {
    CHECK(fault_of({rectangle(0, 0, 4, 1, 0.6)}) ==
          "outer[2]: radius 0.6 does not fit: the side from corner 1 to 2 is 1 long, and its arcs take 1.2");
    CornerChain one = rectangle(0, 0, 4, 1);
    one[0].radius = 1.1;
    CHECK(fault_of({one}) ==
          "outer[0]: radius 1.1 does not fit: the side from corner 3 to 0 is 1 long, and its arcs take 1.1");
}

TEST_CASE("An outline that crosses itself is refused with the place", "[cross_section]") {
    CHECK(fault_of({{{{0, 0}}, {{2, 2}}, {{2, 0}}, {{0, 2}}}}) ==
          "outer[0]: the side from corner 0 to 1 and the side from corner 2 to 3 cross or touch at (1, 1)");
    // Back along the side just walked.
    CHECK(fault_of({{{{0, 0}}, {{2, 0}}, {{1, 0}}, {{0, 2}}}}) ==
          "outer[0]: the side from corner 0 to 1 and the side from corner 1 to 2 cross or touch at (1, 0)");
    // A corner on another side.
    CHECK(fault_of({{{{0, 0}}, {{4, 0}}, {{4, 2}}, {{2, 0}}, {{0, 2}}}}) ==
          "outer[0]: the side from corner 0 to 1 and the side from corner 2 to 3 cross or touch at (2, 0)");
    CHECK(fault_of({rectangle(0, 0, 9, 9), {{{{1, 1}}, {{2, 2}}, {{2, 1}}, {{1, 2}}}}}) ==
          "holes[0][0]: the side from corner 0 to 1 and the side from corner 2 to 3 cross or touch at (1.5, "
          "1.5)");
    // An arc that reaches over the opposite side.
    CHECK(fault_of({{{{0, 0}}, {{4, 0}}, {{4, 3}}, {{2, -0.5}, 0.4}, {{0, 3}}}}) ==
          "outer[0]: the side from corner 0 to 1 and the rounded corner 3 cross or touch at (1.74266, 0)");
}

TEST_CASE("Holes must be inside and apart", "[cross_section]") {
    const CornerChain outer = rectangle(0, 0, 4, 6);
    CHECK(fault_of({outer, {rectangle(0, 1, 2, 2)}}) == "holes[0]: touches the outline at (0, 1)");
    CHECK(fault_of({outer, {rectangle(3, 1, 5, 2)}}) == "holes[0]: touches the outline at (4, 2)");
    CHECK(fault_of({outer, {rectangle(5, 1, 6, 2)}}) == "holes[0]: lies outside the outline");
    const CornerChain hole = rectangle(1, 1, 3, 3);
    CHECK(fault_of({outer, {hole, rectangle(2, 2, 3.5, 5)}}) == "holes[1]: touches holes[0] at (2, 3)");
    CHECK(fault_of({outer, {hole, rectangle(1.5, 1.5, 2, 2)}}) == "holes[1]: lies in holes[0]");
    CHECK(fault_of({outer, {hole, rectangle(0.5, 0.5, 3.5, 5)}}) == "holes[1]: goes around holes[0]");
}

}  // namespace gxrod::test
