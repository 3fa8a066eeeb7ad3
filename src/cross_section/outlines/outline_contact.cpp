#include "cross_section/outlines/outline_contact.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace gxrod {
namespace {

using Points = std::vector<PlanePoint>;

PlanePoint left_of(const PlanePoint& vector) { return {-vector.y(), vector.x()}; }

// The distance of a point of the piece's line or circle from the piece itself: 0 between its ends.
double distance_along(const OutlinePiece& piece, const PlanePoint& point) {
    if (!piece.is_arc()) {
        const PlanePoint along = piece.direction(0.0);
        const double s = along.dot(point - piece.from);
        return std::max({0.0, -s, s - piece.length()});
    }
    const PlanePoint start = piece.from - piece.centre, radius = point - piece.centre;
    const double angle = std::atan2(cross(start, radius), start.dot(radius));
    const double turned = piece.turn > 0.0 ? angle : -angle;  // from −π to π
    if (turned >= 0.0 && turned <= std::abs(piece.turn)) return 0.0;
    return std::min((point - piece.from).norm(), (point - piece.to).norm());
}

// Points of a line nearest to a circle, or in which it cuts the circle.
void meet(const OutlinePiece& line, const OutlinePiece& arc, double within, Points& points) {
    const double radius = (arc.from - arc.centre).norm();
    const PlanePoint along = line.direction(0.0);
    const PlanePoint foot = line.from + along.dot(arc.centre - line.from) * along;
    const double distance = (foot - arc.centre).norm();
    if (distance > radius + within) return;
    const double half = std::sqrt(std::max(0.0, radius * radius - distance * distance));
    points.insert(points.end(), {foot - half * along, foot + half * along});
}

void meet_lines(const OutlinePiece& a, const OutlinePiece& b, Points& points) {
    const PlanePoint one = a.to - a.from, other = b.to - b.from;
    const double product = cross(one, other);
    if (product == 0.0) return;  // the ends of the pieces tell
    points.push_back(a.from + cross(b.from - a.from, other) / product * one);
}

void meet_circles(const OutlinePiece& a, const OutlinePiece& b, double within, Points& points) {
    const double ra = (a.from - a.centre).norm(), rb = (b.from - b.centre).norm();
    const PlanePoint between = b.centre - a.centre;
    const double distance = between.norm();
    if (distance == 0.0 || distance > ra + rb + within || distance < std::abs(ra - rb) - within) return;
    const double s = (distance * distance + ra * ra - rb * rb) / (2.0 * distance);
    const double half = std::sqrt(std::max(0.0, ra * ra - s * s));
    const PlanePoint along = between / distance, foot = a.centre + s * along;
    points.insert(points.end(), {foot - half * left_of(along), foot + half * left_of(along)});
}

// The distance of a point from a piece.
double distance_from(const OutlinePiece& piece, const PlanePoint& point) {
    const double along = distance_along(piece, point);
    const double across = piece.is_arc()
                              ? std::abs((point - piece.centre).norm() - (piece.from - piece.centre).norm())
                              : std::abs(cross(piece.direction(0.0), point - piece.from));
    return std::max(along, across);
}

// What an arc adds to the winding number of its chord.
double wind_around(const OutlinePiece& arc, const PlanePoint& point) {
    const bool is_in_circle = (point - arc.centre).norm() < (arc.from - arc.centre).norm();
    const double side = cross(arc.to - arc.from, point - arc.from);
    return is_in_circle && side * arc.turn < 0.0 ? std::copysign(1.0, arc.turn) : 0.0;
}

}  // namespace

std::optional<PlanePoint> find_contact(const OutlinePiece& a,
                                       const OutlinePiece& b,
                                       double within,
                                       const PlanePoint* shared) {
    Points points{a.from, a.to, b.from, b.to};
    if (a.is_arc() && b.is_arc()) {
        meet_circles(a, b, within, points);
    } else if (a.is_arc() || b.is_arc()) {
        meet(a.is_arc() ? b : a, a.is_arc() ? a : b, within, points);
    } else {
        meet_lines(a, b, points);
    }
    // Next to an end that two pieces with a common tangent share, they are near each other.
    const double reach = shared == nullptr ? 0.0 : 1e-3 * std::min(a.length(), b.length());
    const auto is_contact = [&](const PlanePoint& point) {
        if (shared != nullptr && (point - *shared).norm() <= reach) return false;
        return distance_from(a, point) <= within && distance_from(b, point) <= within;
    };
    const auto found = std::ranges::find_if(points, is_contact);
    return found == points.end() ? std::nullopt : std::optional(*found);
}

bool is_inside(const OutlineLoop& loop, const PlanePoint& point) {
    double windings = 0.0;
    for (const OutlinePiece& piece : loop) {
        const PlanePoint from = piece.from - point, to = piece.to - point;
        windings += std::atan2(cross(from, to), from.dot(to)) / (2.0 * std::numbers::pi);
        if (piece.is_arc()) windings += wind_around(piece, point);
    }
    return std::abs(windings) > 0.5;
}

}  // namespace gxrod
