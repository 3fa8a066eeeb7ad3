#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "cross_section/examination/segment_crossing.hpp"
#include "cross_section/walls/wall_outline.hpp"
#include "cross_section/walls/wall_overlap.hpp"
#include "cross_section/walls/wall_pieces.hpp"

// What is wrong with layups and walls.
namespace gxrod {
namespace {

using Fault = std::optional<WallFault>;

// Mitres of corners that turn back further than this have no end.
constexpr double sharpest_turn = std::numbers::pi - 1e-6;
// Thicknesses are equal up to this.
constexpr double equal_thickness = 1e-9;

std::string corner_part(std::size_t corner) { return fmt::format("corners[{}]", corner); }

const Layup& layup_of(const WallOutline& outline, const std::vector<Layup>& layups, std::size_t side) {
    return layups[outline.layup_of(side)];
}

bool is_between_sides(const WallOutline& outline, std::size_t corner) {
    return outline.is_closed || (corner > 0 && corner + 1 < outline.corners.size());
}

Fault find_count_fault(const WallOutline& outline) {
    const std::size_t least = outline.is_closed ? 3 : 2;
    if (outline.corners.size() < least) {
        return WallFault{"corners",
                         fmt::format("expected {} at least in {} wall, found {}",
                                     least,
                                     outline.is_closed ? "a closed" : "an open",
                                     outline.corners.size())};
    }
    if (outline.layups.size() != 1 && outline.layups.size() != outline.side_count()) {
        return WallFault{"layups",
                         fmt::format("expected one for each of the {} sides, found {}",
                                     outline.side_count(),
                                     outline.layups.size())};
    }
    return std::nullopt;
}

// Two sides that cross, as lines without radii.
Fault find_line_crossing(const WallOutline& outline) {
    std::vector<PlaneSegment> sides;
    for (std::size_t i = 0; i < outline.side_count(); ++i) {
        const PlanePoint& next = outline.corners[(i + 1) % outline.corners.size()].at;
        sides.push_back({outline.corners[i].at, next, static_cast<int>(i)});
    }
    const std::optional<SegmentCrossing> found = find_crossing(std::move(sides));
    if (!found) return std::nullopt;
    const auto [first, second] = std::minmax({found->a.owner, found->b.owner});
    return WallFault{
        "corners",
        fmt::format(
            "sides {} and {} cross at ({:.4g}, {:.4g})", first, second, found->at.x(), found->at.y())};
}

Fault find_place_fault(const WallOutline& outline) {
    double area = 0.0;
    const std::size_t count = outline.corners.size();
    for (std::size_t i = 0; i < count; ++i) {
        const PlanePoint& here = outline.corners[i].at;
        const PlanePoint& next = outline.corners[(i + 1) % count].at;
        area += here.x() * next.y() - here.y() * next.x();
        if (i < outline.side_count() && here == next)
            return WallFault{corner_part((i + 1) % count),
                             fmt::format("is at the same place as corners[{}]", i)};
    }
    if (!outline.is_closed || area > 0.0) return std::nullopt;
    if (Fault fault = find_line_crossing(outline)) return fault;
    return WallFault{
        "corners",
        "go clockwise; a closed wall is walked anticlockwise, as seen with y to the right and z up, "
        "and its plies are listed from outside in: reverse the corners"};
}

// A ply that is thicker than the longest side is long is in another unit.
Fault find_unit_fault(const WallOutline& outline, const std::vector<Layup>& layups) {
    double longest = 0.0;
    for (std::size_t i = 0; i < outline.side_count(); ++i) {
        const PlanePoint& next = outline.corners[(i + 1) % outline.corners.size()].at;
        longest = std::max(longest, (next - outline.corners[i].at).norm());
    }
    for (std::size_t side = 0; side < outline.side_count(); ++side) {
        const Layup& layup = layup_of(outline, layups, side);
        for (const Ply& ply : layup.plies) {
            if (ply.thickness <= longest) continue;
            return WallFault{
                outline.layups.size() == 1 ? "layup" : fmt::format("layups[{}]", side),
                fmt::format("a ply of \"{}\" is {:.4g} thick in a wall whose longest side is {:.4g}: "
                            "are both in one unit?",
                            layup.name,
                            ply.thickness,
                            longest)};
        }
    }
    return std::nullopt;
}

Fault find_thickness_fault(const WallOutline& outline,
                           const std::vector<Layup>& layups,
                           const WallTurn& turn,
                           std::size_t corner) {
    const std::size_t before = (corner + outline.corners.size() - 1) % outline.corners.size();
    const double a = layup_of(outline, layups, before).thickness();
    const double b = layup_of(outline, layups, corner).thickness();
    if (std::abs(a - b) <= equal_thickness * (a + b)) return std::nullopt;
    if (turn.angle != 0.0 && turn.trim == 0.0) return std::nullopt;
    return WallFault{corner_part(corner),
                     fmt::format("the sides before and after it are {:.4g} and {:.4g} thick; walls of two "
                                 "thicknesses meet at a corner without radius only",
                                 a,
                                 b)};
}

Fault find_corner_fault(const WallOutline& outline, const std::vector<Layup>& layups, std::size_t corner) {
    const WallTurn turn = find_wall_turn(outline, layups, corner);
    if (std::abs(turn.angle) > sharpest_turn)
        return WallFault{corner_part(corner), "the wall turns back on itself"};
    if (Fault fault = find_thickness_fault(outline, layups, turn, corner)) return fault;
    if (turn.trim == 0.0) return std::nullopt;
    const double thickness = layup_of(outline, layups, corner).thickness();
    const double right = right_offset(outline.line, thickness);
    // How far the inner surface is from the line.
    const double inwards = turn.angle > 0.0 ? right + thickness : -right;
    const double radius = outline.corners[corner].radius;
    if (radius > inwards) return std::nullopt;
    return WallFault{
        corner_part(corner),
        fmt::format("radius {:.6g} leaves no radius on the inner side of the wall; expected more than "
                    "{:.6g}, or 0 for a mitre",
                    radius,
                    inwards)};
}

Fault find_side_fault(const WallOutline& outline, const std::vector<Layup>& layups, std::size_t side) {
    const std::size_t next = (side + 1) % outline.corners.size();
    const PlanePoint direction = side_direction(outline, side);
    const double whole = (outline.corners[next].at - outline.corners[side].at).dot(direction);
    const WallTurn first =
        is_between_sides(outline, side) ? find_wall_turn(outline, layups, side) : WallTurn{};
    const WallTurn second =
        is_between_sides(outline, next) ? find_wall_turn(outline, layups, next) : WallTurn{};
    const auto taken =
        [&](const WallTurn& turn, const PlanePoint& by, const PlanePoint& corner, double sign) {
            return turn.angle == 0.0 ? 0.0 : sign * (by - corner).dot(direction);
        };
    double left_over = whole;
    for (const auto surface : {&WallCut::right, &WallCut::left}) {
        left_over = std::min(left_over,
                             whole - taken(first, first.after.*surface, outline.corners[side].at, 1.0) -
                                 taken(second, second.before.*surface, outline.corners[next].at, -1.0));
    }
    const bool has_arc = first.trim > 0.0 || second.trim > 0.0;
    // Arcs may take the whole side; a mitre needs some of it.
    if (left_over > 1e-9 * whole || (has_arc && left_over > -1e-9 * whole)) return std::nullopt;
    return WallFault{
        "corners",
        fmt::format("side {} from corners[{}] to corners[{}] is {:.4g} long, shorter than {}, which "
                    "take {:.4g}",
                    side,
                    side,
                    next,
                    whole,
                    has_arc ? "the arcs and mitres at its ends" : "its mitres",
                    whole - left_over)};
}

}  // namespace

std::optional<WallFault> find_fault(const Layup& layup) {
    if (layup.plies.empty()) return WallFault{"plies", "expected one at least"};
    for (std::size_t i = 0; i < layup.plies.size(); ++i) {
        const double thickness = layup.plies[i].thickness;
        if (!(thickness > 0.0))
            return WallFault{fmt::format("plies[{}]", i),
                             thickness == 0.0
                                 ? "thickness is zero"
                                 : fmt::format("thickness is {:.6g}; expected more than 0", thickness)};
    }
    return std::nullopt;
}

std::optional<WallFault> find_fault(const WallOutline& outline, const std::vector<Layup>& layups) {
    if (Fault fault = find_count_fault(outline)) return fault;
    if (Fault fault = find_place_fault(outline)) return fault;
    if (Fault fault = find_unit_fault(outline, layups)) return fault;
    for (std::size_t corner = 0; corner < outline.corners.size(); ++corner) {
        if (!is_between_sides(outline, corner)) continue;
        if (Fault fault = find_corner_fault(outline, layups, corner)) return fault;
    }
    for (std::size_t side = 0; side < outline.side_count(); ++side) {
        if (Fault fault = find_side_fault(outline, layups, side)) return fault;
    }
    return find_wall_overlap(list_wall_pieces(outline, layups));
}

}  // namespace gxrod
