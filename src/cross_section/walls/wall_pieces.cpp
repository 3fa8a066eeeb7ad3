#include "cross_section/walls/wall_pieces.hpp"

#include <cmath>

namespace gxrod {
namespace {

// Smaller turns do not count as turns.
constexpr double no_turn = 1e-9;
// Pieces shorter than this, over the length of their side, are left out.
constexpr double no_length = 1e-9;

PlanePoint left_normal(const PlanePoint& direction) { return {-direction.y(), direction.x()}; }

PlanePoint on_circle(double angle) { return {std::cos(angle), std::sin(angle)}; }

// A side with its layup's surfaces.
struct WallStrip {
    PlanePoint direction, normal;
    double right = 0.0, left = 0.0;  // offsets of the surfaces from the line

    PlanePoint offset(double across) const { return (right + across * (left - right)) * normal; }
    // Cuts it at a point of its line, at right angles.
    WallCut cut_at(const PlanePoint& at) const { return {at + offset(0.0), at + offset(1.0)}; }
};

WallStrip make_strip(const WallOutline& outline, const std::vector<Layup>& layups, std::size_t side) {
    const PlanePoint direction = side_direction(outline, side);
    const double thickness = layups[outline.layup_of(side)].thickness();
    const double right = right_offset(outline.line, thickness);
    return {direction, left_normal(direction), right, right + thickness};
}

// Returns where two lines at offsets from the two sides of a corner meet.
PlanePoint meet_surfaces(
    const PlanePoint& corner, const WallStrip& a, double offset_a, const WallStrip& b, double offset_b) {
    const double along = (offset_b - offset_a * a.normal.dot(b.normal)) / a.direction.dot(b.normal);
    return corner + offset_a * a.normal + along * a.direction;
}

std::size_t next_corner(const WallOutline& outline, std::size_t corner) {
    return (corner + 1) % outline.corners.size();
}

std::size_t side_before(const WallOutline& outline, std::size_t corner) {
    return (corner + outline.corners.size() - 1) % outline.corners.size();
}

WallPiece make_straight(std::size_t side,
                        const PlanePoint& direction,
                        const WallCut& start,
                        const WallCut& end) {
    return {.side = side, .start = start, .end = end, .direction = direction};
}

// Makes a part of the arc of a corner, between two fractions of its turn.
WallPiece make_arc_piece(const WallOutline& outline,
                         const std::vector<Layup>& layups,
                         std::size_t corner,
                         std::size_t side,
                         double from,
                         double to) {
    const WallTurn turn = find_wall_turn(outline, layups, corner);
    const WallStrip before = make_strip(outline, layups, side_before(outline, corner));
    const double radius = outline.corners[corner].radius;
    const double bend = turn.angle > 0.0 ? 1.0 : -1.0;
    const PlanePoint touch = outline.corners[corner].at - turn.trim * before.direction;
    const PlanePoint outwards = -bend * before.normal;
    WallPiece piece{.side = side, .direction = before.direction};
    piece.centre = touch - radius * outwards;
    piece.from_angle = std::atan2(outwards.y(), outwards.x()) + from * turn.angle;
    piece.turn = (to - from) * turn.angle;
    piece.right_radius = radius - bend * before.right;
    piece.left_radius = radius - bend * before.left;
    const auto cut = [&](double angle) -> WallCut {
        return {piece.centre + piece.right_radius * on_circle(angle),
                piece.centre + piece.left_radius * on_circle(angle)};
    };
    piece.start = cut(piece.from_angle);
    piece.end = cut(piece.from_angle + piece.turn);
    return piece;
}

void add_arc(const WallOutline& outline,
             const std::vector<Layup>& layups,
             std::size_t corner,
             std::vector<WallPiece>& pieces) {
    const std::size_t before = side_before(outline, corner);
    if (outline.layup_of(before) == outline.layup_of(corner)) {
        pieces.push_back(make_arc_piece(outline, layups, corner, before, 0.0, 1.0));
    } else {
        pieces.push_back(make_arc_piece(outline, layups, corner, before, 0.0, 0.5));
        pieces.push_back(make_arc_piece(outline, layups, corner, corner, 0.5, 1.0));
    }
}

// Marks the ends of pieces at which stresses change quickly.
void mark_sharp_ends(const WallOutline& outline, std::vector<WallPiece>& pieces) {
    const std::size_t count = pieces.size();
    for (std::size_t i = 0; i < count; ++i) {
        WallPiece& piece = pieces[i];
        WallPiece& next = pieces[(i + 1) % count];
        const bool is_free = !outline.is_closed && i + 1 == count;
        const bool is_mitred = piece.wall(1.0).dot(next.wall(0.0)) < 1.0 - no_turn;
        const bool changes = outline.layup_of(piece.side) != outline.layup_of(next.side);
        piece.ends_sharply = next.starts_sharply = is_free || is_mitred || changes;
    }
}

}  // namespace

double Layup::thickness() const {
    double sum = 0.0;
    for (const Ply& ply : plies) sum += ply.thickness;
    return sum;
}

double WallPiece::length() const {
    if (is_arc()) return 0.5 * (right_radius + left_radius) * std::abs(turn);
    return (end.at(0.5) - start.at(0.5)).norm();
}

PlanePoint WallPiece::at(double along, double across) const {
    if (!is_arc()) return start.at(across) + along * (end.at(across) - start.at(across));
    const double radius = right_radius + across * (left_radius - right_radius);
    return centre + radius * on_circle(from_angle + along * turn);
}

PlanePoint WallPiece::wall(double along) const {
    if (!is_arc()) return direction;
    return (turn > 0.0 ? 1.0 : -1.0) * left_normal(on_circle(from_angle + along * turn));
}

double right_offset(WallSide line, double thickness) {
    if (line == WallSide::right) return 0.0;
    return line == WallSide::left ? -thickness : -0.5 * thickness;
}

PlanePoint side_direction(const WallOutline& outline, std::size_t side) {
    return (outline.corners[next_corner(outline, side)].at - outline.corners[side].at).normalized();
}

WallTurn find_wall_turn(const WallOutline& outline, const std::vector<Layup>& layups, std::size_t corner) {
    const WallStrip a = make_strip(outline, layups, side_before(outline, corner));
    const WallStrip b = make_strip(outline, layups, corner);
    const auto& [at, radius] = outline.corners[corner];
    WallTurn turn{.angle = std::atan2(a.normal.dot(b.direction), a.direction.dot(b.direction))};
    if (std::abs(turn.angle) < no_turn) {
        turn.angle = 0.0;
        turn.before = a.cut_at(at);
        turn.after = b.cut_at(at);
    } else if (radius > 0.0) {
        turn.trim = radius * std::tan(0.5 * std::abs(turn.angle));
        turn.before = a.cut_at(at - turn.trim * a.direction);
        turn.after = b.cut_at(at + turn.trim * b.direction);
    } else {
        turn.before = {meet_surfaces(at, a, a.right, b, b.right), meet_surfaces(at, a, a.left, b, b.left)};
        turn.after = turn.before;
    }
    return turn;
}

std::vector<WallPiece> list_wall_pieces(const WallOutline& outline, const std::vector<Layup>& layups) {
    std::vector<WallPiece> pieces;
    for (std::size_t side = 0; side < outline.side_count(); ++side) {
        const WallStrip strip = make_strip(outline, layups, side);
        const std::size_t next = next_corner(outline, side);
        const bool starts_free = !outline.is_closed && side == 0;
        const bool ends_free = !outline.is_closed && side + 1 == outline.side_count();
        const WallCut start = starts_free ? strip.cut_at(outline.corners[side].at)
                                          : find_wall_turn(outline, layups, side).after;
        const WallTurn turn = ends_free
                                  ? WallTurn{.before = strip.cut_at(outline.corners[next].at), .after = {}}
                                  : find_wall_turn(outline, layups, next);
        const double length = (turn.before.right - start.right).dot(strip.direction);
        const double whole = (outline.corners[next].at - outline.corners[side].at).norm();
        if (length > no_length * whole)
            pieces.push_back(make_straight(side, strip.direction, start, turn.before));
        if (turn.trim > 0.0) add_arc(outline, layups, next, pieces);
    }
    mark_sharp_ends(outline, pieces);
    return pieces;
}

}  // namespace gxrod
