#include "contact/obstacle_distance.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <concepts>
#include <limits>
#include <optional>
#include <variant>

#include "contact/contact_law.hpp"
#include "contact/pairs/advancement.hpp"
#include "rotation/rotation_map.hpp"

namespace gxrod {

namespace {

// The closest point of a line, and what the distance from it needs: its unit tangent, zero at an end, and its
// curvature vector c″.
struct ClosestOnLine {
    Vec3 position = Vec3::Zero();
    Vec3 tangent = Vec3::Zero();
    Vec3 curvature = Vec3::Zero();
};

ClosestOnLine find_closest_on(const SphereShape& sphere, const Vec3& /*point*/) {
    return {sphere.centre, Vec3::Zero(), Vec3::Zero()};
}

ClosestOnLine find_closest_on(const CylinderShape& cylinder, const Vec3& point) {
    const Vec3 start = cylinder.from;
    const Vec3 extent = cylinder.to - start;
    const double length = extent.norm();
    const Vec3 axis = extent / length;
    double s = (point - start).dot(axis);
    const bool is_beyond = !cylinder.is_hollow && (s < 0.0 || s > length);
    if (is_beyond) s = std::clamp(s, 0.0, length);
    return {start + s * axis, is_beyond ? Vec3::Zero() : axis, Vec3::Zero()};
}

// Of a tube, a cubic Hermite piece between two points, by u = 0 … 1.
struct Piece {
    Vec3 p0, p1, m0, m1;

    Vec3 position(double u) const {
        const double w = 1.0 - u;
        return (1.0 + 2.0 * u) * w * w * p0 + u * w * w * m0 + u * u * (3.0 - 2.0 * u) * p1 - u * u * w * m1;
    }
    Vec3 first(double u) const {
        return 6.0 * u * (1.0 - u) * (p1 - p0) + (1.0 - u) * (1.0 - 3.0 * u) * m0 + u * (3.0 * u - 2.0) * m1;
    }
    Vec3 second(double u) const {
        return (6.0 - 12.0 * u) * (p1 - p0) + (6.0 * u - 4.0) * m0 + (6.0 * u - 2.0) * m1;
    }
};

Piece piece_of(const TubeShape& tube, std::size_t index) {
    const Vec3& p0 = tube.line[index];
    const Vec3& p1 = tube.line[index + 1];
    // As a circle has it, whose pieces are then off by δ⁶ of their angle δ.
    const double half = std::sqrt(0.5 * (1.0 + tube.tangents[index].dot(tube.tangents[index + 1])));
    const double length = 2.0 * (p1 - p0).norm() / (1.0 + half);
    return {p0, p1, length * tube.tangents[index], length * tube.tangents[index + 1]};
}

// u of the point of a piece that is closest, by Newton's method kept within the piece.
double find_parameter(const Piece& piece, const Vec3& point) {
    double low = 0.0, high = 1.0;
    const auto slope = [&](double u) { return (piece.position(u) - point).dot(piece.first(u)); };
    if (slope(0.0) >= 0.0) return 0.0;
    if (slope(1.0) <= 0.0) return 1.0;
    double u = 0.5;
    for (int iteration = 0; iteration < 60; ++iteration) {
        const double value = slope(u);
        (value > 0.0 ? high : low) = u;
        const double derivative =
            piece.first(u).squaredNorm() + (piece.position(u) - point).dot(piece.second(u));
        double next = derivative > 0.0 ? u - value / derivative : 0.5 * (low + high);
        if (next <= low || next >= high) next = 0.5 * (low + high);
        if (std::abs(next - u) <= 1e-15) return next;
        u = next;
    }
    return u;
}

ClosestOnLine find_closest_on(const TubeShape& tube, const Vec3& point) {
    const std::size_t pieces = tube.line.size() - 1;
    double near = std::numeric_limits<double>::infinity();  // no less than the distance that is sought
    for (const Vec3& place : tube.line) near = std::min(near, (point - place).squaredNorm());
    near = std::sqrt(near);
    double least = std::numeric_limits<double>::infinity();
    std::size_t best = 0;
    double u = 0.0;
    for (std::size_t index = 0; index < pieces; ++index) {
        const Vec3& start = tube.line[index];
        const Vec3& end = tube.line[index + 1];
        // A piece is no further from the middle of its chord than its chord is long.
        const double length = (end - start).norm();
        if ((point - 0.5 * (start + end)).norm() - length > std::min(near, least)) continue;
        const Piece piece = piece_of(tube, index);
        const double at = find_parameter(piece, point);
        const double distance = (piece.position(at) - point).norm();
        if (distance >= least) continue;
        least = distance;
        best = index;
        u = at;
    }
    const auto end_of = [&](bool is_start) -> const Vec3& {
        return is_start ? tube.line.front() : tube.line.back();
    };
    if (tube.is_hollow) {
        std::optional<ClosestOnLine> beyond;
        for (const bool is_start : {true, false}) {
            const Vec3& axis = is_start ? tube.tangents.front() : tube.tangents.back();
            const double s = (point - end_of(is_start)).dot(axis);
            if (is_start ? s >= 0.0 : s <= 0.0) continue;
            const Vec3 position = end_of(is_start) + s * axis;
            if ((point - position).norm() > least) continue;
            least = (point - position).norm();
            beyond = {position, axis, Vec3::Zero()};
        }
        if (beyond) return *beyond;
    } else if ((best == 0 && u == 0.0) || (best + 1 == pieces && u == 1.0)) {
        return {end_of(u == 0.0), Vec3::Zero(), Vec3::Zero()};
    }
    const Piece piece = piece_of(tube, best);
    const Vec3 first = piece.first(u);
    const double speed = first.norm();
    const Vec3 tangent = first / speed;
    const Vec3 second = piece.second(u) / (speed * speed);
    return {piece.position(u), tangent, second - second.dot(tangent) * tangent};
}

ObstacleDistance distance_from_shape(const PlaneShape& plane, const Vec3& point) {
    ObstacleDistance result;
    result.position = plane.point;
    result.distance = (point - plane.point).dot(plane.normal);
    result.normal = plane.normal;
    return result;
}

// MeshSurface finds it.
ObstacleDistance distance_from_shape(const MeshShape& /*mesh*/, const Vec3& /*point*/) {
    assert(!"a mesh has surfaces of its own");
    return {};
}

template <std::derived_from<RoundShape> Shape>
ObstacleDistance distance_from_shape(const Shape& shape, const Vec3& point) {
    ObstacleDistance result;
    const ClosestOnLine closest = find_closest_on(shape, point);
    result.position = closest.position;
    const Vec3 offset = point - closest.position;
    const double d = offset.norm();
    const double sign = shape.is_hollow ? -1.0 : 1.0;
    result.distance = sign * (d - shape.radius);
    if (d == 0.0) return result;
    const Vec3 n = offset / d;
    result.normal = sign * n;
    // The closest point follows by t (t · δx)/m, m = 1 − offset · c″.
    const double m = 1.0 - offset.dot(closest.curvature);
    const Vec3& t = closest.tangent;
    result.curvature = (sign / d) * (Mat3::Identity() - n * n.transpose() - t * t.transpose() / m);
    return result;
}

}  // namespace

ObstacleDistance find_obstacle_distance(const Obstacle& obstacle, const Vec3& point) {
    return std::visit([&](const auto& shape) { return distance_from_shape(shape, point); }, obstacle.shape);
}

ObstaclePlacement place_obstacle(const Obstacle& obstacle, double time) {
    ObstaclePlacement placement;
    if (!obstacle.motion) return placement;
    placement.displacement = obstacle.motion->displacement(time);
    placement.rotation = obstacle.motion->rotation(time);
    placement.about = obstacle.motion->about;
    placement.turn = exp_matrix(placement.rotation);
    return placement;
}

ObstaclePlacement between(const ObstaclePlacement& from, const ObstaclePlacement& to, double fraction) {
    if (fraction == 1.0) return to;
    ObstaclePlacement placement = to;
    placement.displacement = from.displacement + fraction * (to.displacement - from.displacement);
    placement.rotation = from.rotation + fraction * (to.rotation - from.rotation);
    placement.turn = exp_matrix(placement.rotation);
    return placement;
}

ObstacleDistance find_obstacle_distance(const Obstacle& obstacle,
                                        const ObstaclePlacement& placement,
                                        const Vec3& point) {
    if (!obstacle.motion) return find_obstacle_distance(obstacle, point);
    ObstacleDistance result = find_obstacle_distance(obstacle, placement.to_start(point));
    const Mat3& Q = placement.turn;
    result.normal = Q * result.normal;
    result.curvature = Q * result.curvature * Q.transpose();
    result.position = placement.from_start(result.position);
    return result;
}

FreeMotion find_free_motion(
    const Obstacle& obstacle, double radius, const Vec3& from, const Vec3& to, double skin) {
    const Vec3 motion = to - from;
    const double length = motion.norm();
    const bool is_convex = std::visit([](const auto& shape) { return shape.is_convex(); }, obstacle.shape);
    const auto measure = [&](double t) {
        const ObstacleDistance at = find_obstacle_distance(obstacle, from + t * motion);
        return GapAndSpeed{at.distance - radius, is_convex ? -at.normal.dot(motion) : length};
    };
    const double gap = measure(0.0).gap;
    AdvancementLimits kept;
    if (skin > 0.0) kept.kept_share = find_predicted_share(skin, gap);
    if ((1.0 - kept.kept_share) * gap >= length) return {1.0, gap};
    return {advance(measure, kept).fraction, gap};
}

}  // namespace gxrod
