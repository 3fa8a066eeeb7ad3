#include "cross_section/outlines/outline_examination.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "cross_section/outlines/outline_contact.hpp"

namespace gxrod {
namespace {

// Pieces nearer than this part of the extent touch.
constexpr double touching = 1e-9;

double find_extent(const CornerChain& chain) {
    PlanePoint least = chain.front().at, greatest = least;
    for (const OutlineCorner& corner : chain) {
        least = least.cwiseMin(corner.at);
        greatest = greatest.cwiseMax(corner.at);
    }
    return (greatest - least).maxCoeff();
}

// Which chain of a polygon: the outer one, or a hole.
using WhichChain = std::optional<std::size_t>;

std::string name_chain(WhichChain hole) { return hole ? fmt::format("holes[{}]", *hole) : "outer"; }

OutlineFault make_fault(WhichChain hole, std::size_t corner, std::string message) {
    return {fmt::format("{}[{}]", name_chain(hole), corner), std::move(message), hole, corner};
}

OutlineFault make_fault(WhichChain hole, std::string message) {
    return {name_chain(hole), std::move(message), hole, std::nullopt};
}

// "(0.1, 0.2)".
std::string describe_place(const PlanePoint& point) {
    return fmt::format("({:.6g}, {:.6g})", point.x(), point.y());
}

std::optional<OutlineFault> find_repeated_corner(const CornerChain& chain, WhichChain hole, double within) {
    for (std::size_t i = 0; i < chain.size(); ++i) {
        const std::size_t next = (i + 1) % chain.size();
        if ((chain[i].at - chain[next].at).norm() > within) continue;
        const bool closes = next == 0;
        return make_fault(
            hole,
            std::max(i, next),
            fmt::format("repeats corner {}{}",
                        std::min(i, next),
                        closes ? "; the last side goes back to the first corner by itself" : ""));
    }
    return std::nullopt;
}

std::optional<OutlineFault> find_radius_that_does_not_fit(const CornerChain& chain, WhichChain hole) {
    // Arcs may use up a side.
    constexpr double round_off = 1e-9;
    for (std::size_t i = 0; i < chain.size(); ++i) {
        const std::size_t next = (i + 1) % chain.size();
        const double first = compute_tangent_length(chain, i), second = compute_tangent_length(chain, next);
        const double side = (chain[next].at - chain[i].at).norm();
        if (first + second <= side * (1.0 + round_off)) continue;
        const std::size_t worse = first > second ? i : next;
        return make_fault(
            hole,
            worse,
            fmt::format(
                "radius {:.6g} does not fit: the side from corner {} to {} is {:.6g} long, and its arcs "
                "take {:.6g}",
                chain[worse].radius,
                i,
                next,
                side,
                first + second));
    }
    return std::nullopt;
}

std::optional<OutlineFault> find_fault_in_corners(const CornerChain& chain, WhichChain hole, double within) {
    if (chain.size() < 3)
        return make_fault(hole, fmt::format("expected three corners or more, found {}", chain.size()));
    if (auto fault = find_repeated_corner(chain, hole, within)) return fault;
    return find_radius_that_does_not_fit(chain, hole);
}

// "corner 3" or "the side from corner 3 to 4".
std::string describe_piece(const OutlinePiece& piece) {
    return piece.is_arc() ? fmt::format("the rounded corner {}", piece.corner)
                          : fmt::format("the side from corner {} to {}", piece.corner, piece.next);
}

std::optional<OutlineFault> find_self_contact(const OutlineLoop& loop, WhichChain hole, double within) {
    for (std::size_t i = 0; i < loop.size(); ++i) {
        for (std::size_t j = i + 1; j < loop.size(); ++j) {
            const bool follows = j == i + 1, precedes = i == 0 && j + 1 == loop.size();
            const PlanePoint* shared = follows ? &loop[j].from : precedes ? &loop[i].from : nullptr;
            const auto at = find_contact(loop[i], loop[j], within, shared);
            if (!at) continue;
            return make_fault(hole,
                              static_cast<std::size_t>(loop[i].corner),
                              fmt::format("{} and {} cross or touch at {}",
                                          describe_piece(loop[i]),
                                          describe_piece(loop[j]),
                                          describe_place(*at)));
        }
    }
    return std::nullopt;
}

std::optional<PlanePoint> find_contact_of_loops(const OutlineLoop& a, const OutlineLoop& b, double within) {
    for (const OutlinePiece& one : a) {
        for (const OutlinePiece& other : b) {
            if (auto at = find_contact(one, other, within)) return at;
        }
    }
    return std::nullopt;
}

std::optional<OutlineFault> find_fault_of_hole(const Outline& outline, std::size_t hole, double within) {
    const OutlineLoop& loop = outline.holes[hole];
    if (const auto at = find_contact_of_loops(loop, outline.outer, within))
        return make_fault(hole, "touches the outline at " + describe_place(*at));
    if (!is_inside(outline.outer, loop.front().from)) return make_fault(hole, "lies outside the outline");
    for (std::size_t other = 0; other < hole; ++other) {
        const OutlineLoop& before = outline.holes[other];
        if (const auto at = find_contact_of_loops(loop, before, within))
            return make_fault(hole, fmt::format("touches holes[{}] at {}", other, describe_place(*at)));
        if (is_inside(before, loop.front().from))
            return make_fault(hole, fmt::format("lies in holes[{}]", other));
        if (is_inside(loop, before.front().from))
            return make_fault(hole, fmt::format("goes around holes[{}]", other));
    }
    return std::nullopt;
}

}  // namespace

std::optional<OutlineFault> find_fault(const Polygon& polygon) {
    if (polygon.outer.empty()) return make_fault({}, "expected three corners or more, found 0");
    const double within = touching * find_extent(polygon.outer);
    if (auto fault = find_fault_in_corners(polygon.outer, {}, within)) return fault;
    for (std::size_t i = 0; i < polygon.holes.size(); ++i) {
        if (auto fault = find_fault_in_corners(polygon.holes[i], i, within)) return fault;
    }
    if (auto fault = find_self_contact(round_corners(polygon.outer), {}, within)) return fault;
    for (std::size_t i = 0; i < polygon.holes.size(); ++i) {
        if (auto fault = find_self_contact(round_corners(polygon.holes[i]), i, within)) return fault;
    }
    const Outline outline = draw_outline(polygon);
    for (std::size_t i = 0; i < outline.holes.size(); ++i) {
        if (auto fault = find_fault_of_hole(outline, i, within)) return fault;
    }
    return std::nullopt;
}

}  // namespace gxrod
