#include <algorithm>
#include <cmath>
#include <cstdint>

#include "assembly/contact/contact_pairs.hpp"

// Where rods that touch at the end of a step were closest at its start.
namespace gxrod {

OpenEnds ContactPairs::open_ends(const NearPieces& near) const {
    const ContactPiece &a = lines_.pieces[near.first], &b = lines_.pieces[near.second];
    const bool is_line_a = !lines_.element_of(a).is_body, is_line_b = !lines_.element_of(b).is_body;
    return {is_line_a && !a.starts_rod,
            is_line_a && !a.ends_rod,
            is_line_b && !b.starts_rod,
            is_line_b && !b.ends_rod};
}

// Beyond an end of the rod, and across the seam of a closed one, it is the piece itself.
std::uint32_t ContactPairs::find_next(std::uint32_t piece, int steps) const {
    const std::int64_t next = static_cast<std::int64_t>(piece) + steps;
    if (next < 0 || next >= static_cast<std::int64_t>(lines_.pieces.size())) return piece;
    const auto index = static_cast<std::uint32_t>(next);
    return lines_.element_of(lines_.pieces[index]).rod == lines_.element_of(lines_.pieces[piece]).rod ? index
                                                                                                      : piece;
}

NearPieces ContactPairs::find_nearest(NearPieces near, const std::vector<Segment>& segments) const {
    constexpr int furthest = 16;
    const auto step_from = [](double place, bool open_start, bool open_end) {
        if (place == 0.0 && open_start) return -1;
        return place == 1.0 && open_end ? 1 : 0;
    };
    ClosestPoints closest = find_closest_points(segments[near.first], segments[near.second]);
    for (int i = 0; i < furthest; ++i) {
        const OpenEnds open = open_ends(near);
        const NearPieces next{find_next(near.first, step_from(closest.s, open.a_start, open.a_end)),
                              find_next(near.second, step_from(closest.t, open.b_start, open.b_end))};
        if (next == near || !lines_.can_touch(lines_.pieces[next.first], lines_.pieces[next.second])) break;
        const ClosestPoints there = find_closest_points(segments[next.first], segments[next.second]);
        if (there.distance >= closest.distance) break;
        near = next, closest = there;
    }
    return near;
}

PairStart ContactPairs::find_start(const NearPieces& near, const std::vector<Segment>& before) const {
    const auto contact_of = [&](const NearPieces& pieces) {
        return find_open_contact(before[pieces.first], before[pieces.second], open_ends(pieces));
    };
    const NearPieces nearest = find_nearest(near, before);
    PairStart start;
    start.distance = find_closest_points(before[nearest.first], before[nearest.second]).distance;
    start.ends = find_ends(before[near.first], before[near.second]);
    // What goes on straight has the same direction at rest, but not where a rod is bent far from its piece.
    constexpr double furthest = 4.0;
    OpenContact contact = contact_of(near);
    if (std::max(std::abs(contact.s - 0.5), std::abs(contact.t - 0.5)) > furthest) {
        contact = contact_of(nearest);
        contact.s += static_cast<int>(nearest.first) - static_cast<int>(near.first);
        contact.t += static_cast<int>(nearest.second) - static_cast<int>(near.second);
    }
    start.s = contact.s, start.t = contact.t;
    start.offset = contact.offset;
    return start;
}

}  // namespace gxrod
