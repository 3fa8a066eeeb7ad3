#include <fmt/format.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>

#include "deck/joints/ends.hpp"
#include "deck/joints/joint_table.hpp"
#include "rotation/vector_text.hpp"

namespace gxrod {
namespace {

// Points nearer than this, relative to the model's size, are at one place.
constexpr double same_place = 1e-9;
// Cosine of the angle of axes that are at right angles.
constexpr double right_angle = 1e-9;

// The points of A and B; nullopt of the ground.
using Points = std::array<std::optional<PlacedPoint>, 2>;

std::optional<Points> find_points(const JointTable& given, const BuildContext& context) {
    Points points;
    for (std::size_t i = 0; i < 2; ++i) {
        const std::string& word = given.between[i].word;
        if (word == ground_word) continue;
        points[i] = context.place(word);
        if (!points[i]) return std::nullopt;
    }
    return points;
}

// Whether the sides can move against each other; a fault if not.
bool are_apart(const JointTable& given, const Points& points, const BuildContext& context) {
    const std::string& a = given.between[0].word;
    const std::string& b = given.between[1].word;
    if (!points[0] && !points[1]) {
        context.add_fault(
            given, given.between, "both sides are the ground; expected a point that moves, too");
        return false;
    }
    if (!points[0] || !points[1] || points[0]->node != points[1]->node) return true;
    context.add_fault(
        given,
        given.between,
        a == b
            ? fmt::format("both sides are \"{}\"; expected two points that can move against each other", a)
            : fmt::format("\"{}\" and \"{}\" are one node, which a [[connect]] or the `at` of a body makes "
                          "rigid; expected two nodes",
                          a,
                          b));
    return false;
}

// Where the joint is if the deck does not say: where both sides are, or the only one that is a point of a
// rod. nullopt, with a fault, if these are several places.
std::optional<Vec3> find_common_place(const JointTable& given,
                                      const Points& points,
                                      double size,
                                      const BuildContext& context) {
    const auto place = [&](std::size_t i) { return context.model.nodes[points[i]->node].position; };
    if (!points[0]) return place(1);
    if (!points[1]) return place(0);
    const double distance = (place(1) - place(0)).norm();
    if (distance <= same_place * size) return place(0);
    const bool is_a_of_body = points[0]->body >= 0;
    if (is_a_of_body != (points[1]->body >= 0)) return is_a_of_body ? place(1) : place(0);
    const auto& words = given.between;
    context.add_fault(
        given,
        given.between,
        fmt::format("the points are {:.6g} apart; expected `at`: {} is where \"{}\" is, {} where "
                    "\"{}\" is",
                    distance,
                    in_brackets(place(0), 9),
                    words[0].word,
                    in_brackets(place(1), 9),
                    words[1].word));
    return std::nullopt;
}

Anchor anchor_at(const std::optional<PlacedPoint>& point, const Vec3& place, const Model& model) {
    if (!point) return {.arm = place};
    return {.node = point->node, .arm = place - model.nodes[point->node].position};
}

bool place_at_one_point(const JointTable& given, double size, Joint& joint, const BuildContext& context) {
    const std::optional<Points> points = find_points(given, context);
    if (!points || !are_apart(given, *points, context)) return false;
    const std::optional<Vec3> place = given.at ? given.at : find_common_place(given, *points, size, context);
    if (!place) return false;
    joint.a.anchor = anchor_at((*points)[0], *place, context.model);
    joint.b.anchor = anchor_at((*points)[1], *place, context.model);
    return true;
}

bool place_at_two_points(const JointTable& given, Joint& joint, const BuildContext& context) {
    const std::optional<Points> points = find_points(given, context);
    if (!points || !are_apart(given, *points, context)) return false;
    const std::optional<Anchor> a = find_anchor(given, given.between[0], given.at_a, context);
    const std::optional<Anchor> b = find_anchor(given, given.between[1], given.at_b, context);
    if (!a || !b) return false;
    joint.a.anchor = *a;
    joint.b.anchor = *b;
    return true;
}

// Of a distance joint, whose points are two.
bool place_apart(const JointTable& given, double size, Joint& joint, const BuildContext& context) {
    if (!place_at_two_points(given, joint, context)) return false;
    const double now =
        (find_place(context.model, joint.b.anchor) - find_place(context.model, joint.a.anchor)).norm();
    const double least = same_place * std::max(size, now);
    joint.length = given.length.value_or(now);
    joint.pulls_only = given.slack.value_or(false);
    if (joint.pulls_only && given.length) {
        if (joint.length >= now - least) return true;
        context.add_fault(
            given,
            given.length,
            fmt::format("the points are {:.9g} apart at t = 0; expected at least this length", now));
        return false;
    }
    if (now <= least) {
        context.add_fault(given,
                          given.between,
                          "the points are at one place, where their distance has no direction; expected "
                          "points apart, or a ball");
        return false;
    }
    if (std::abs(now - joint.length) <= least) return true;
    context.add_fault(
        given,
        given.length,
        fmt::format("the points are {:.9g} apart at t = 0; expected this length, or none", now));
    return false;
}

// A direction of length 1; nullopt, with a fault, of no length.
std::optional<Vec3> find_axis(const JointTable& given,
                              const std::optional<Vec3>& axis,
                              const BuildContext& context) {
    if (axis->stableNorm() > 0.0) return axis->stableNormalized();
    context.add_fault(given, axis, "has no length; expected a direction");
    return std::nullopt;
}

// The axis and two across it, the first of these towards the global axis that is most across it.
Mat3 axes_about(const Vec3& axis) {
    int across = 0;
    axis.cwiseAbs().minCoeff(&across);
    Mat3 axes;
    axes.col(0) = axis;
    axes.col(1) = (Vec3::Unit(across) - axis[across] * axis).normalized();
    axes.col(2) = axes.col(0).cross(axes.col(1));
    return axes;
}

// A direction of length 1 at right angles to the axis; nullopt, with a fault, of another one.
std::optional<Vec3> find_across(const JointTable& given,
                                const std::optional<Vec3>& direction,
                                const Vec3& axis,
                                const BuildContext& context) {
    const std::optional<Vec3> across = find_axis(given, direction, context);
    if (!across) return std::nullopt;
    const double dot = axis.dot(*across);
    if (std::abs(dot) > right_angle) {
        context.add_fault(
            given,
            direction,
            fmt::format("expected a direction at right angles to axis; the product of both, as unit vectors, "
                        "is {:.6g}",
                        dot));
        return std::nullopt;
    }
    return (*across - dot * axis).normalized();
}

// Of a universal joint: A's axes are axis, axis_b and their product, B's axis_b, axis and theirs.
bool set_crossed_axes(const JointTable& given, const Vec3& a, Joint& joint, const BuildContext& context) {
    const std::optional<Vec3> b = find_across(given, given.axis_b, a, context);
    if (!b) return false;
    joint.a.axes << a, *b, a.cross(*b);
    joint.b.axes << *b, a, b->cross(a);
    return true;
}

// A cam's curve lies across `axis`, its first coordinate along `x_axis`, which may be given.
bool set_cam_axes(const JointTable& given, const Vec3& normal, Joint& joint, const BuildContext& context) {
    joint.a.axes = axes_about(normal);
    if (given.x_axis) {
        const std::optional<Vec3> x = find_across(given, given.x_axis, normal, context);
        if (!x) return false;
        joint.a.axes << normal, *x, normal.cross(*x);
    }
    joint.b.axes = joint.a.axes;
    return true;
}

// A generic joint's x axis is `axis`; its y axis may be given.
bool set_three_axes(const JointTable& given, const Vec3& x, Joint& joint, const BuildContext& context) {
    joint.a.axes = axes_about(x);
    if (given.y_axis) {
        const std::optional<Vec3> y = find_across(given, given.y_axis, x, context);
        if (!y) return false;
        joint.a.axes << x, *y, x.cross(*y);
    }
    joint.b.axes = joint.a.axes;
    return true;
}

bool set_axes(const JointTable& given, Joint& joint, const BuildContext& context) {
    if (!given.axis) return true;
    const std::optional<Vec3> axis = find_axis(given, given.axis, context);
    if (!axis) return false;
    if (joint.kind == JointKind::universal) return set_crossed_axes(given, *axis, joint, context);
    if (joint.kind == JointKind::generic) return set_three_axes(given, *axis, joint, context);
    if (joint.kind == JointKind::cam) return set_cam_axes(given, *axis, joint, context);
    joint.a.axes = joint.b.axes = axes_about(*axis);
    return true;
}

bool set_points(const JointTable& given, double size, Joint& joint, const BuildContext& context) {
    if (joint.kind == JointKind::distance) return place_apart(given, size, joint, context);
    if (joint.kind == JointKind::cam) return place_at_two_points(given, joint, context);
    return place_at_one_point(given, size, joint, context);
}

}  // namespace

bool place_joint(const JointTable& given, double size, Joint& joint, const BuildContext& context) {
    const bool is_placed = set_points(given, size, joint, context);
    if (!set_axes(given, joint, context) || !is_placed) return false;
    return joint.kind != JointKind::cam || set_cam(given, size, joint, context);
}

}  // namespace gxrod
