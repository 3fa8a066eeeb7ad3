#include <algorithm>
#include <cmath>

#include "assembly/contact/contact_pairs.hpp"
#include "contact/pairs/advancement.hpp"
#include "numerics/disjoint_sets.hpp"
#include "rotation/rotation_map.hpp"

// How far rods may move so that they do not pass through each other, and which are expected to touch.
namespace gxrod {

namespace {

// Of ζ: softer than what follows from how deep an increment would go, whose stiffness grows with ζ². Eight
// rods of order 2 that land on eight others at 2 m/s take 35 steps and 10 s with these bounds, 52 and 19 s
// without expectations, and more than a minute without bounds.
constexpr double first_expected = -0.8, most_expected = 0.5;

double largest_motion(const Segment& motion) { return std::max(motion.start.norm(), motion.end.norm()); }

Segment add(const Segment& segment, const Segment& motion) {
    return {segment.start + motion.start, segment.end + motion.end};
}

// By how much the distance changes, to first order.
double find_change(const ClosestPoints& closest, const Segment& motion_a, const Segment& motion_b) {
    return closest.offset.dot(motion_a.at(closest.s) - motion_b.at(closest.t)) / closest.distance;
}

}  // namespace

ContactPairs::PieceMotion ContactPairs::find_motion(std::size_t piece,
                                                    double part,
                                                    const State& state,
                                                    const std::vector<Vec6>& increments) const {
    const ContactPlaces& all = lines_.places;
    const ContactPlace& start = all.places[lines_.pieces[piece].place];
    const ContactPlace& end = all.places[lines_.pieces[piece].place + 1];
    const ContactElement& element = all.elements[static_cast<std::size_t>(start.element)];
    if (!element.is_body) {
        const Segment all_of_it{all.change(start, state, increments), all.change(end, state, increments)};
        return {{part * all_of_it.start, part * all_of_it.end}};
    }
    const Vec6& increment = increments[static_cast<std::size_t>(element.nodes[0])];
    const Vec3 turn = part * increment.tail<3>();
    PieceMotion motion;
    const auto move = [&](const ContactPlace& place) {
        const Vec3 arm = all.arm(place, state.trial);
        // An eighth of the second derivative.
        motion.aside = std::max(motion.aside, turn.norm() * turn.cross(arm).norm() / 8.0);
        return Vec3(part * increment.head<3>() + exp_quaternion(turn) * arm - arm);
    };
    motion.chord.start = move(start);
    motion.chord.end = move(end);
    return motion;
}

std::vector<ContactPairs::PieceMotion> ContactPairs::find_motions(const State& state,
                                                                  const std::vector<Vec6>& increments) const {
    std::vector<PieceMotion> motions(lines_.pieces.size());
    team_->for_each_range(motions.size(), [&](std::size_t first, std::size_t last) {
        for (std::size_t i = first; i < last; ++i) motions[i] = find_motion(i, 1.0, state, increments);
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
                                                 const Wanted& wanted,
                                                 const State& state,
                                                 Approach approach,
                                                 double& expected) const {
    const Segment& a = wanted.at[near.first];
    const Segment& b = wanted.at[near.second];
    PieceMotion move_a = wanted.motions[near.first];
    PieceMotion move_b = wanted.motions[near.second];
    const ContactLaw law = expected_law_of(near);
    const double radii = law_of(near).radii;
    const ClosestPoints closest = find_closest_points(a, b);
    const double gap = closest.distance - radii, change = find_change(closest, move_a.chord, move_b.chord);
    PairLimit limit{1.0, gap, false};
    AdvancementLimits kept;
    kept.kept_share = approach == Approach::prediction ? find_predicted_share(law.skin, gap)
                                                       : find_kept_share(law.skin, gap);
    const bool was_expected = expected > no_contact;
    if (was_expected) {
        expected = std::min(advance_contact(law, expected, gap, change), most_expected);
        const ContactGraphPoint next = find_contact_point(law, expected);
        // It may come as near as its force says, but not so near that it would be thrown back.
        kept.kept_share = std::min(kept.kept_share, std::max(0.5 * next.gap, 0.3 * law.skin) / gap);
        // From here on it touches.
        if (compute_contact_force(law, gap) > 0.25 * next.force) expected = no_contact;
    }
    double aside = move_a.aside + move_b.aside;
    if ((1.0 - kept.kept_share) * gap >= largest_motion(move_a.chord) + largest_motion(move_b.chord) + aside)
        return limit;
    limit.can_meet = true;
    double part = 1.0;
    // So much that ways leave their chords by a quarter of the gap at most.
    if (aside > 0.25 * gap) {
        part = gap > 0.0 ? std::sqrt(0.25 * gap / aside) : 0.0;
        move_a = find_motion(near.first, part, state, *wanted.increments);
        move_b = find_motion(near.second, part, state, *wanted.increments);
        aside = move_a.aside + move_b.aside;
    }
    part *= advance_capsules(a, add(a, move_a.chord), b, add(b, move_b.chord), radii + aside, kept).fraction;
    limit.fraction = keep_from_rounding(part, law.skin, gap);
    // Without inertia the two laws of pairs that lie along each other take turns.
    if (has_impacts_ && part < 1.0 && !was_expected && gap > law.skin)
        expected = std::clamp(-(gap + change) / law.skin, no_contact, first_expected);
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

void ContactPairs::limit(const std::vector<Vec6>& increments,
                         State& state,
                         Approach approach,
                         ContactLimits& limits) const {
    const double all = find_room(find_reach(increments), state);
    const Wanted wanted{&increments, find_segments(state.trial), find_motions(state, increments)};
    ContactTrial& contact = state.contact;
    std::vector<PairLimit> of_pairs(contact.pieces.size());
    team_->for_each_range(of_pairs.size(), [&](std::size_t first, std::size_t last) {
        for (std::size_t i = first; i < last; ++i)
            of_pairs[i] = limit_pair(contact.pieces[i], wanted, state, approach, contact.pieces_expected[i]);
    });
    join_limits(of_pairs, all, state, limits);
}

}  // namespace gxrod
