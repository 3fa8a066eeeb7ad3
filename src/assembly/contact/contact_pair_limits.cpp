#include <algorithm>

#include "assembly/contact/contact_pairs.hpp"
#include "contact/advancement.hpp"
#include "numerics/disjoint_sets.hpp"

// How far rods may move so that they do not pass through each other, and which are expected to touch.
namespace gxrod {

namespace {

double largest_motion(const Segment& motion) { return std::max(motion.start.norm(), motion.end.norm()); }

Segment add(const Segment& segment, const Segment& motion) {
    return {segment.start + motion.start, segment.end + motion.end};
}

// By how much the distance changes, to first order.
double find_change(const ClosestPoints& closest, const Segment& motion_a, const Segment& motion_b) {
    return closest.offset.dot(motion_a.at(closest.s) - motion_b.at(closest.t)) / closest.distance;
}

}  // namespace

std::vector<Segment> ContactPairs::find_motions(const std::vector<Vec3>& displacements) const {
    std::vector<Segment> motions(lines_.pieces.size());
    team_->for_each_range(motions.size(), [&](std::size_t first, std::size_t last) {
        for (std::size_t i = first; i < last; ++i) {
            const ContactPiece& piece = lines_.pieces[i];
            const ContactElement& element = lines_.element_of(piece);
            const auto sum = [&](std::size_t place) {
                Vec3 motion = Vec3::Zero();
                for (std::size_t n = 0; n < static_cast<std::size_t>(element.count); ++n)
                    motion += lines_.places.places[place].shapes[n] *
                              displacements[static_cast<std::size_t>(element.nodes[n])];
                return motion;
            };
            motions[i] = {sum(piece.place), sum(piece.place + 1)};
        }
    });
    return motions;
}

double ContactPairs::find_room(double reach, State& state) const {
    ContactTrial& contact = state.contact;
    const double skin = largest_skin();
    if (contact.margin == 0.0) contact.pieces_expected.clear();
    if (contact.margin == 0.0 || skin + 2.0 * (contact.travelled + reach) > contact.margin)
        search(reach, state);
    const double room = 0.5 * (contact.margin - skin) - contact.travelled;
    contact.travelled += std::min(reach, room);
    return reach > room ? room / reach : 1.0;
}

ContactLaw ContactPairs::expected_law_of(const NearPieces& near) const {
    ContactLaw law = law_of(near).law;
    law.stiffness *= find_share_of_crossing(near);
    return law;
}

ContactPairs::PairLimit ContactPairs::limit_pair(const NearPieces& near,
                                                 const std::vector<Segment>& at,
                                                 const std::vector<Segment>& motions,
                                                 Approach approach,
                                                 double& expected) const {
    const Segment& a = at[near.first];
    const Segment& b = at[near.second];
    const Segment& move_a = motions[near.first];
    const Segment& move_b = motions[near.second];
    const ContactLaw law = expected_law_of(near);
    const double radii = law_of(near).radii;
    const ClosestPoints closest = find_closest_points(a, b);
    PairLimit limit;
    limit.gap = closest.distance - radii;
    AdvancementLimits kept;
    kept.kept_share = approach == Approach::prediction ? find_predicted_share(law.skin, limit.gap)
                                                       : find_kept_share(law.skin, limit.gap);
    const bool was_expected = expected > no_contact;
    if (was_expected) {
        expected = advance_contact(law, expected, limit.gap, find_change(closest, move_a, move_b));
        const ContactGraphPoint next = find_contact_point(law, expected);
        // It may come as near as its force says, but not so near that it would be thrown back.
        const double least = std::max(0.5 * next.gap, 0.3 * law.skin);
        kept.kept_share = std::min(kept.kept_share, least / limit.gap);
        // From here on it touches.
        if (compute_contact_force(law, limit.gap) > 0.25 * next.force) expected = no_contact;
    }
    if ((1.0 - kept.kept_share) * limit.gap >= largest_motion(move_a) + largest_motion(move_b)) return limit;
    limit.can_meet = true;
    const Advancement free = advance_capsules(a, add(a, move_a), b, add(b, move_b), radii, kept);
    limit.fraction = keep_from_rounding(free.fraction, law.skin, limit.gap);
    if (free.fraction < 1.0 && !was_expected && limit.gap > law.skin)
        expected = std::max(-(limit.gap + find_change(closest, move_a, move_b)) / law.skin, no_contact);
    return limit;
}

void ContactPairs::join_limits(const std::vector<PairLimit>& of_pairs,
                               double all,
                               const State& state,
                               ContactLimits& limits) const {
    DisjointSets islands(limits.of_parts.size());
    for (std::size_t i = 0; i < of_pairs.size(); ++i) {
        limits.least_gap = std::min(limits.least_gap, of_pairs[i].gap);
        if (!of_pairs[i].can_meet) continue;
        const NearPieces& near = state.contact.pieces[i];
        const auto a = static_cast<std::size_t>(lines_.element_of(lines_.pieces[near.first]).part);
        const auto b = static_cast<std::size_t>(lines_.element_of(lines_.pieces[near.second]).part);
        islands.join(static_cast<int>(a), static_cast<int>(b));
        limits.of_parts[a] = std::min(limits.of_parts[a], of_pairs[i].fraction);
    }
    std::vector<double> of_islands(limits.of_parts.size(), all);
    for (std::size_t part = 0; part < of_islands.size(); ++part) {
        double& island = of_islands[static_cast<std::size_t>(islands.find(static_cast<int>(part)))];
        island = std::min(island, limits.of_parts[part]);
    }
    for (std::size_t part = 0; part < of_islands.size(); ++part) {
        limits.of_parts[part] = of_islands[static_cast<std::size_t>(islands.find(static_cast<int>(part)))];
        limits.least = std::min(limits.least, limits.of_parts[part]);
    }
}

void ContactPairs::limit(const std::vector<Vec3>& displacements,
                         State& state,
                         Approach approach,
                         ContactLimits& limits) const {
    double reach = 0.0;
    for (const Vec3& one : displacements) reach = std::max(reach, one.norm());
    const double all = find_room(largest_shape_sum * reach, state);
    const std::vector<Segment> at = find_segments(state.trial);
    const std::vector<Segment> motions = find_motions(displacements);
    ContactTrial& contact = state.contact;
    std::vector<PairLimit> of_pairs(contact.pieces.size());
    team_->for_each_range(of_pairs.size(), [&](std::size_t first, std::size_t last) {
        for (std::size_t i = first; i < last; ++i)
            of_pairs[i] = limit_pair(contact.pieces[i], at, motions, approach, contact.pieces_expected[i]);
    });
    join_limits(of_pairs, all, state, limits);
}

}  // namespace gxrod
