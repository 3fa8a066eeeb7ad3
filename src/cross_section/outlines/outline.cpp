#include "cross_section/outlines/outline.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

namespace gxrod {
namespace {

PlanePoint turn_by(const PlanePoint& vector, double angle) { return Eigen::Rotation2Dd(angle) * vector; }

const PlanePoint& corner_before(const CornerChain& chain, std::size_t corner) {
    return chain[(corner + chain.size() - 1) % chain.size()].at;
}

const PlanePoint& corner_after(const CornerChain& chain, std::size_t corner) {
    return chain[(corner + 1) % chain.size()].at;
}

// The angle by which the walk turns at a corner, anticlockwise positive.
double compute_turn(const CornerChain& chain, std::size_t corner) {
    const PlanePoint in = chain[corner].at - corner_before(chain, corner);
    const PlanePoint out = corner_after(chain, corner) - chain[corner].at;
    return std::atan2(cross(in, out), in.dot(out));
}

// The arc of a corner; a point where it has none.
OutlinePiece make_arc(const CornerChain& chain, std::size_t corner) {
    const PlanePoint& at = chain[corner].at;
    const double length = compute_tangent_length(chain, corner);
    const PlanePoint in = (at - corner_before(chain, corner)).normalized();
    const PlanePoint out = (corner_after(chain, corner) - at).normalized();
    OutlinePiece arc{.from = at - length * in, .to = at + length * out};
    arc.corner = arc.next = static_cast<int>(corner);
    if (length == 0.0) return arc;
    arc.turn = compute_turn(chain, corner);
    const double side = arc.turn > 0.0 ? 1.0 : -1.0;
    arc.centre = arc.from + side * chain[corner].radius * PlanePoint(-in.y(), in.x());
    return arc;
}

OutlineLoop reverse_loop(OutlineLoop loop) {
    std::ranges::reverse(loop);
    for (OutlinePiece& piece : loop) {
        std::swap(piece.from, piece.to);
        std::swap(piece.corner, piece.next);
        piece.turn = -piece.turn;
    }
    return loop;
}

OutlineLoop draw_circle(double radius) {
    const std::array<PlanePoint, 4> points{{{radius, 0.0}, {0.0, radius}, {-radius, 0.0}, {0.0, -radius}}};
    OutlineLoop loop;
    for (int i = 0; i < 4; ++i) {
        const int next = (i + 1) % 4;
        loop.push_back({.from = points[i],
                        .to = points[next],
                        .turn = 0.5 * std::numbers::pi,
                        .corner = i,
                        .next = next});
    }
    return loop;
}

template <class Change>
void change_points(Outline& outline, const Change& change) {
    const auto change_loop = [&](OutlineLoop& loop) {
        for (OutlinePiece& piece : loop) {
            change(piece.from);
            change(piece.to);
            change(piece.centre);
        }
    };
    change_loop(outline.outer);
    std::ranges::for_each(outline.holes, change_loop);
}

}  // namespace

double OutlinePiece::length() const {
    return is_arc() ? std::abs(turn) * (from - centre).norm() : (to - from).norm();
}

PlanePoint OutlinePiece::at(double fraction) const {
    if (fraction == 0.0) return from;
    if (fraction == 1.0) return to;
    if (!is_arc()) return from + fraction * (to - from);
    return centre + turn_by(from - centre, fraction * turn);
}

PlanePoint OutlinePiece::direction(double fraction) const {
    if (!is_arc()) return (to - from).normalized();
    const PlanePoint radius = turn_by(from - centre, fraction * turn).normalized();
    return (turn > 0.0 ? 1.0 : -1.0) * PlanePoint(-radius.y(), radius.x());
}

std::vector<const OutlineLoop*> Outline::loops() const {
    std::vector<const OutlineLoop*> all{&outer};
    for (const OutlineLoop& hole : holes) all.push_back(&hole);
    return all;
}

double compute_signed_area(const CornerChain& chain) {
    double twice = 0.0;
    for (std::size_t i = 0; i < chain.size(); ++i) {
        twice += cross(chain[i].at - chain[0].at, corner_after(chain, i) - chain[0].at);
    }
    return 0.5 * twice;
}

double compute_tangent_length(const CornerChain& chain, std::size_t corner) {
    constexpr double straight = 1e-9;
    const double turn = std::abs(compute_turn(chain, corner));
    return turn < straight ? 0.0 : chain[corner].radius * std::tan(0.5 * turn);
}

OutlineLoop round_corners(const CornerChain& chain) {
    // Sides that arcs use up leave round-off.
    constexpr double nothing = 1e-12;
    OutlineLoop loop;
    OutlinePiece before = make_arc(chain, 0);
    for (std::size_t i = 0; i < chain.size(); ++i) {
        const std::size_t next = (i + 1) % chain.size();
        OutlinePiece after = make_arc(chain, next);
        if (before.is_arc()) loop.push_back(before);
        const double side = (chain[next].at - chain[i].at).norm();
        const OutlinePiece straight{.from = before.to,
                                    .to = after.from,
                                    .corner = static_cast<int>(i),
                                    .next = static_cast<int>(next)};
        if ((after.from - before.to).norm() > nothing * side) loop.push_back(straight);
        before = after;
    }
    for (std::size_t i = 0; i < loop.size(); ++i) loop[i].to = loop[(i + 1) % loop.size()].from;
    return loop;
}

Outline draw_outline(const Polygon& polygon) {
    const auto draw = [](const CornerChain& chain, bool anticlockwise) {
        OutlineLoop loop = round_corners(chain);
        return (compute_signed_area(chain) > 0.0) == anticlockwise ? loop : reverse_loop(std::move(loop));
    };
    Outline outline{.outer = draw(polygon.outer, true)};
    for (const CornerChain& hole : polygon.holes) outline.holes.push_back(draw(hole, false));
    return outline;
}

Outline draw_ring(double outer_radius, double inner_radius) {
    Outline outline{.outer = draw_circle(outer_radius)};
    if (inner_radius > 0.0) outline.holes.push_back(reverse_loop(draw_circle(inner_radius)));
    return outline;
}

Outline move_outline(Outline outline, const PlanePoint& by) {
    change_points(outline, [&](PlanePoint& point) { point += by; });
    return outline;
}

Outline scale_outline(Outline outline, double factor) {
    change_points(outline, [&](PlanePoint& point) { point *= factor; });
    return outline;
}

}  // namespace gxrod
