// Lines through points in a plane: circles and ellipses, whose curvatures are known, and parabolas.

#include "numerics/plane_curve.hpp"

#include <cmath>
#include <numbers>
#include <random>

#include "tools/catch.hpp"

using namespace gxrod;

namespace {

using CurvePoint = PlaneCurve::Point;

// x = a cos u, y = b sin u.
CurvePoint ellipse_at(double a, double b, double u) { return {a * std::cos(u), b * std::sin(u)}; }

PlaneCurve make_ellipse(double a, double b, int count, double sense = 1.0) {
    std::vector<CurvePoint> points;
    for (int i = 0; i < count; ++i)
        points.push_back(ellipse_at(a, b, sense * 2.0 * std::numbers::pi * i / count));
    return {points, true};
}

// Of the ellipse at its parameter u, and its derivative by the arc length.
double ellipse_curvature(double a, double b, double u) {
    return a * b / std::pow(std::pow(a * std::sin(u), 2) + std::pow(b * std::cos(u), 2), 1.5);
}
double ellipse_curvature_rate(double a, double b, double u) {
    const double square = std::pow(a * std::sin(u), 2) + std::pow(b * std::cos(u), 2);
    const double by_u = -3.0 * a * b * (a * a - b * b) * std::sin(u) * std::cos(u) / std::pow(square, 2.5);
    return by_u / std::sqrt(square);
}

// The largest errors of the ellipse 2 by 1 through so many points, off its line and in its curvature.
std::array<double, 3> measure_errors(int count) {
    const double a = 2.0, b = 1.0;
    const PlaneCurve curve = make_ellipse(a, b, count);
    std::array<double, 3> errors{};
    for (const PlaneCurve::Place& place : curve.list_places(7)) {
        const auto& [x, y] = std::pair(place.point.x(), place.point.y());
        const double u = std::atan2(y / b, x / a);
        const double off = x * x / (a * a) + y * y / (b * b) - 1.0;
        errors[0] = std::max(errors[0], std::abs(off));
        errors[1] = std::max(errors[1], std::abs(place.curvature - ellipse_curvature(a, b, u)));
        errors[2] = std::max(errors[2], std::abs(place.curvature_rate - ellipse_curvature_rate(a, b, u)));
    }
    return errors;
}

// The nearest of very many places.
double search_distance(const PlaneCurve& curve, const CurvePoint& point) {
    double least = 1e300;
    for (const PlaneCurve::Place& place : curve.list_places(200))
        least = std::min(least, (place.point - point).norm());
    return least;
}

}  // namespace

TEST_CASE("a circle through points is a circle", "[numerics][curves]") {
    const double radius = 0.7;
    const PlaneCurve curve = make_ellipse(radius, radius, 48);
    CHECK(curve.is_counter_clockwise());
    CHECK(curve.length() == Approx(2.0 * std::numbers::pi * radius).epsilon(1e-9));
    for (const PlaneCurve::Place& place : curve.list_places(5)) {
        CHECK(place.point.norm() == Approx(radius).epsilon(1e-9));
        CHECK(std::abs(place.tangent.dot(place.point)) < 1e-8);
        CHECK(place.curvature == Approx(1.0 / radius).epsilon(1e-6));
        CHECK(std::abs(place.curvature_rate) < 1e-4);
    }
    const PlaneCurve back = make_ellipse(radius, radius, 48, -1.0);
    CHECK_FALSE(back.is_counter_clockwise());
    CHECK(back.find_place(0.3).curvature == Approx(-1.0 / radius).epsilon(1e-6));
}

TEST_CASE("lines through points converge with order six", "[numerics][curves]") {
    const auto coarse = measure_errors(60), fine = measure_errors(120);
    CHECK(coarse[0] / fine[0] > std::pow(2.0, 5.5));
    CHECK(coarse[1] / fine[1] > std::pow(2.0, 3.5));
    CHECK(coarse[2] / fine[2] > std::pow(2.0, 2.5));
    CHECK(fine[0] < 1e-7);
}

TEST_CASE("places of a line are arc lengths", "[numerics][curves]") {
    const PlaneCurve curve = make_ellipse(2.0, 1.0, 120);
    // The perimeter by the complete elliptic integral.
    CHECK(curve.length() == Approx(4.0 * 2.0 * std::comp_ellint_2(std::sqrt(0.75))).epsilon(1e-9));
    const double h = 1e-4;
    for (double s = 0.05; s < curve.length(); s += 0.37) {
        const CurvePoint moved = curve.find_place(s + h).point - curve.find_place(s - h).point;
        CHECK(moved.norm() / (2.0 * h) == Approx(1.0).epsilon(1e-7));
        const double turned = curve.find_place(s + h).curvature - curve.find_place(s - h).curvature;
        CHECK(turned / (2.0 * h) == Approx(curve.find_place(s).curvature_rate).margin(1e-6));
    }
    // Once around.
    const CurvePoint there = curve.find_place(1.1).point;
    CHECK((curve.find_place(1.1 - 2.0 * curve.length()).point - there).norm() < 1e-13);
}

TEST_CASE("curvatures of a line are continuous at its points", "[numerics][curves]") {
    const PlaneCurve curve = make_ellipse(2.0, 1.0, 40);
    const double h = 1e-9;
    for (const PlaneCurve::Place& place : curve.list_places(1)) {
        const auto before = curve.find_place(place.arc_length - h),
                   after = curve.find_place(place.arc_length + h);
        CHECK(before.curvature == Approx(after.curvature).epsilon(1e-7));
        CHECK(before.curvature_rate == Approx(after.curvature_rate).margin(1e-6));
    }
}

TEST_CASE("the nearest place of a line is found from anywhere", "[numerics][curves]") {
    const PlaneCurve curve = make_ellipse(2.0, 1.0, 50);
    std::mt19937 random(31);
    std::uniform_real_distribution<double> number(-3.0, 3.0);
    for (int i = 0; i < 200; ++i) {
        const CurvePoint point(number(random), number(random));
        const PlaneCurve::Place place = curve.find_nearest(point);
        const double distance = (place.point - point).norm();
        CHECK(distance <= search_distance(curve, point) + 1e-13);
        CHECK(std::abs(place.tangent.dot(point - place.point)) < 1e-13);
        CHECK(place.arc_length >= 0.0);
        CHECK(place.arc_length <= curve.length());
    }
    // Across the seam, and on the line itself.
    for (const double s : {0.0, 1e-12, -1e-12, 0.01, -0.01, 2.0}) {
        const PlaneCurve::Place there = curve.find_place(s);
        CHECK((curve.find_nearest(there.point).point - there.point).norm() < 1e-14);
    }
}

TEST_CASE("a polynomial of degree five is its own line", "[numerics][curves]") {
    // By arc length a straight line is one.
    std::vector<CurvePoint> points;
    for (const double s : {0.0, 0.2, 0.5, 0.9, 1.0, 1.7, 2.0}) points.emplace_back(1.0 + 0.6 * s, 0.8 * s);
    const PlaneCurve line(points, false);
    CHECK_FALSE(line.is_closed());
    CHECK(line.length() == Approx(2.0).epsilon(1e-14));
    for (const PlaneCurve::Place& place : line.list_places(4)) {
        CHECK((place.point - CurvePoint(1.0 + 0.6 * place.arc_length, 0.8 * place.arc_length)).norm() <
              1e-13);
        CHECK(std::abs(place.curvature) < 1e-10);
    }
}

TEST_CASE("an open line has its curvature up to the ends, and goes straight beyond them",
          "[numerics][curves]") {
    std::vector<CurvePoint> points;
    for (int i = 0; i <= 40; ++i) points.push_back(ellipse_at(1.0, 1.0, 0.04 * i));
    const PlaneCurve arc(points, false);
    CHECK(arc.length() == Approx(1.6).epsilon(1e-10));
    for (const PlaneCurve::Place& place : arc.list_places(3)) {
        CHECK(place.point.norm() == Approx(1.0).epsilon(1e-10));
        CHECK(place.curvature == Approx(1.0).epsilon(3e-6));
    }
    const PlaneCurve::Place before = arc.find_nearest({1.1, -0.3});
    CHECK(before.arc_length == Approx(-0.3).epsilon(1e-6));
    CHECK(before.curvature == 0.0);
    CHECK((before.point - CurvePoint(1.0, -0.3)).norm() < 1e-8);
    const PlaneCurve::Place after =
        arc.find_nearest(points.back() + 0.2 * CurvePoint(-std::sin(1.6), std::cos(1.6)));
    CHECK(after.arc_length == Approx(1.8).epsilon(1e-9));
}
