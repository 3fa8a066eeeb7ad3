#include "assembly/contact/contact_pairs.hpp"

#include <algorithm>
#include <cmath>

#include "contact/advancement.hpp"
#include "numerics/disjoint_sets.hpp"
#include "rotation/rotation_map.hpp"

namespace gxrod {

namespace {

double largest_motion(const Segment& motion) { return std::max(motion.start.norm(), motion.end.norm()); }

Segment add(const Segment& segment, const Segment& motion) {
    return {segment.start + motion.start, segment.end + motion.end};
}

}  // namespace

ContactPairs::ContactPairs(const Model& model, const ThreadTeam& team, const ScaleGroups& groups)
    : model_(&model), team_(&team), groups_(&groups) {
    if (model.contact.radii.empty() && model.contact.bodies.empty()) return;
    lines_ = find_contact_lines(model);
    friction_ = model.contact.friction;
    for (ContactElement& element : lines_.places.elements)
        element.part = groups.part_of_node(element.nodes[0]);
}

Segment ContactPairs::segment_of(std::size_t piece, const std::vector<NodeMotion>& motions) const {
    const ContactPlaces& all = lines_.places;
    const std::size_t place = lines_.pieces[piece].place;
    return {all.position(all.places[place], motions), all.position(all.places[place + 1], motions)};
}

PairLaw ContactPairs::law_of(const NearPieces& near) const {
    const ContactElement& a = lines_.element_of(lines_.pieces[near.first]);
    const ContactElement& b = lines_.element_of(lines_.pieces[near.second]);
    // A crossing of the weaker of the two at half the skin carries a thousandth of its EA.
    return {a.radius + b.radius,
            {std::min(a.law.skin, b.law.skin),
             2.0 * std::min(a.law.stiffness * a.radius, b.law.stiffness * b.radius)}};
}

PairEnergy ContactPairs::find_energy(const NearPieces& near, const std::vector<NodeMotion>& motions) const {
    const PairLaw pair = law_of(near);
    const ContactPiece& of_a = lines_.pieces[near.first];
    const ContactPiece& of_b = lines_.pieces[near.second];
    const Segment a = segment_of(near.first, motions);
    const Segment b = segment_of(near.second, motions);
    PairEnergy sum;
    // A sphere has no line.
    if (of_a.length > 0.0 && of_b.length > 0.0)
        sum = compute_pair_energy(pair, a, b, of_a.length, of_b.length);
    const auto add = [&](const PairEnergy& more, const std::array<int, 4>& ends) {
        sum.energy += more.energy;
        for (int i = 0; i < 4; ++i) {
            sum.gradient.segment<3>(3 * ends[static_cast<std::size_t>(i)]) += more.gradient.segment<3>(3 * i);
            for (int j = 0; j < 4; ++j)
                sum.hessian.block<3, 3>(3 * ends[static_cast<std::size_t>(i)],
                                        3 * ends[static_cast<std::size_t>(j)]) +=
                    more.hessian.block<3, 3>(3 * i, 3 * j);
        }
    };
    // A point is a segment whose ends are the same. Points of bodies see a line as long as they touch it, so
    // that nothing changes where two pieces meet.
    const auto add_ends = [&](const ContactPiece& piece, const ContactPiece& of_other, bool is_first) {
        const Segment& own = is_first ? a : b;
        const Segment& other = is_first ? b : a;
        if (piece.length > 0.0 && of_other.length == 0.0) return;
        if (piece.length == 0.0 && of_other.length == 0.0 && !is_first) return;
        const bool sees_line = lines_.element_of(piece).is_body && of_other.length > 0.0;
        for (int end = 0; end < 2; ++end) {
            if (!(end == 0 ? piece.starts_rod : piece.ends_rod)) continue;
            const Vec3& point = end == 0 ? own.start : own.end;
            const int at = (is_first ? 0 : 2) + end;
            add(sees_line ? compute_point_energy(pair, point, other, of_other.length)
                          : compute_closest_energy(pair, {point, point}, other),
                {at, at, is_first ? 2 : 0, is_first ? 3 : 1});
        }
    };
    add_ends(of_a, of_b, true);
    add_ends(of_b, of_a, false);
    return sum;
}

double ContactPairs::least_gap(const NearPieces& near, const std::vector<NodeMotion>& motions) const {
    return find_closest_points(segment_of(near.first, motions), segment_of(near.second, motions)).distance -
           law_of(near).radii;
}

void ContactPairs::search(double reach, State& state) const {
    double skin = 0.0, thickest = 0.0;
    std::vector<Capsule> capsules(lines_.pieces.size());
    for (std::size_t i = 0; i < capsules.size(); ++i) {
        const ContactElement& element = lines_.element_of(lines_.pieces[i]);
        const Segment segment = segment_of(i, state.trial);
        capsules[i] = {segment.start, segment.end, element.radius};
        skin = std::max(skin, element.law.skin);
        thickest = std::max(thickest, element.radius);
    }
    ContactTrial& contact = state.contact;
    // Motions beyond that are shortened.
    contact.margin = skin + 2.0 * std::clamp(reach, 0.25 * thickest, 4.0 * thickest);
    contact.travelled = 0.0;
    const auto keep = [&](CapsulePair pair) {
        return lines_.can_touch(lines_.pieces[pair.first], lines_.pieces[pair.second]);
    };
    const std::vector<NearPieces> before = std::move(contact.pieces);
    contact.pieces.clear();
    for (const CapsulePair pair : find_near_pairs(capsules, contact.margin, keep)) {
        contact.pieces.push_back({pair.first, pair.second});
    }
    if (!rub()) return;
    const std::vector<Vec3> sliding = std::move(contact.pieces_sliding);
    contact.pieces_sliding.assign(contact.pieces.size(), Vec3::Zero());
    for (std::size_t i = 0; i < contact.pieces.size() && !sliding.empty(); ++i) {
        const auto own = std::ranges::lower_bound(before, contact.pieces[i]);
        if (own != before.end() && *own == contact.pieces[i])
            contact.pieces_sliding[i] = sliding[static_cast<std::size_t>(own - before.begin())];
    }
}

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

NodeGroup ContactPairs::list_nodes(int a, int b) const {
    NodeGroup group;
    for (const int index : {a, b}) {
        const ContactElement& element = lines_.places.elements[static_cast<std::size_t>(index)];
        for (int i = 0; i < element.count; ++i) {
            const int node = element.nodes[static_cast<std::size_t>(i)];
            if (std::ranges::find(group, node) == group.end()) group.push_back(node);
        }
    }
    return group;
}

std::vector<NodeGroup> ContactPairs::list_groups(const State& state) const {
    std::vector<std::pair<int, int>> elements;
    for (const NearPieces& near : state.contact.pieces)
        elements.emplace_back(element_of(near.first), element_of(near.second));
    std::ranges::sort(elements);
    elements.erase(std::ranges::unique(elements).begin(), elements.end());
    std::vector<NodeGroup> groups;
    for (const auto& [a, b] : elements) groups.push_back(list_nodes(a, b));
    return groups;
}

void ContactPairs::limit(const std::vector<Vec6>& increments,
                         State& state,
                         Approach approach,
                         ContactLimits& limits) const {
    double reach = 0.0;
    for (const Vec6& one : increments) reach = std::max(reach, one.head<3>().norm());
    reach *= largest_shape_sum;
    for (auto element = lines_.places.elements.rbegin();
         element != lines_.places.elements.rend() && element->is_body;
         ++element)
        reach = std::max(reach, lines_.places.reach(*element, increments));
    ContactTrial& contact = state.contact;
    double skin = 0.0;
    for (const ContactElement& element : lines_.places.elements) skin = std::max(skin, element.law.skin);
    if (contact.margin == 0.0 || skin + 2.0 * (contact.travelled + reach) > contact.margin)
        search(reach, state);
    double all = 1.0;
    const double room = 0.5 * (contact.margin - skin) - contact.travelled;
    if (reach > room) all = room / reach;
    std::vector<double> of_pairs(contact.pieces.size(), 1.0), gaps(contact.pieces.size());
    std::vector<char> can_meet(contact.pieces.size(), 0);
    team_->for_each_range(of_pairs.size(), [&](std::size_t first, std::size_t last) {
        for (std::size_t i = first; i < last; ++i) {
            const NearPieces& near = contact.pieces[i];
            gaps[i] = least_gap(near, state.trial);
            const Segment a = segment_of(near.first, state.trial);
            const Segment b = segment_of(near.second, state.trial);
            const PairLaw pair = law_of(near);
            AdvancementLimits kept;
            kept.kept_share = approach == Approach::prediction ? find_predicted_share(pair.law.skin, gaps[i])
                                                               : find_kept_share(pair.law.skin, gaps[i]);
            PieceMotion move_a = find_motion(near.first, 1.0, state, increments);
            PieceMotion move_b = find_motion(near.second, 1.0, state, increments);
            double aside = move_a.aside + move_b.aside;
            if ((1.0 - kept.kept_share) * gaps[i] >=
                largest_motion(move_a.chord) + largest_motion(move_b.chord) + aside)
                continue;
            can_meet[i] = 1;
            double part = 1.0;
            // So much that ways leave their chords by a quarter of the gap at most.
            if (aside > 0.25 * gaps[i]) {
                part = gaps[i] > 0.0 ? std::sqrt(0.25 * gaps[i] / aside) : 0.0;
                move_a = find_motion(near.first, part, state, increments);
                move_b = find_motion(near.second, part, state, increments);
                aside = move_a.aside + move_b.aside;
            }
            of_pairs[i] =
                part *
                advance_capsules(a, add(a, move_a.chord), b, add(b, move_b.chord), pair.radii + aside, kept)
                    .fraction;
            of_pairs[i] = keep_from_rounding(of_pairs[i], pair.law.skin, gaps[i]);
        }
    });
    DisjointSets islands(limits.of_parts.size());
    for (std::size_t i = 0; i < of_pairs.size(); ++i) {
        limits.least_gap = std::min(limits.least_gap, gaps[i]);
        if (can_meet[i] == 0) continue;
        const NearPieces& near = contact.pieces[i];
        const auto a = static_cast<std::size_t>(lines_.element_of(lines_.pieces[near.first]).part);
        const auto b = static_cast<std::size_t>(lines_.element_of(lines_.pieces[near.second]).part);
        islands.join(static_cast<int>(a), static_cast<int>(b));
        limits.of_parts[a] = std::min(limits.of_parts[a], of_pairs[i]);
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
    contact.travelled += std::min(reach, room);
}

void ContactPairs::count(const State& state, ContactCount& result) const {
    for (const NearPieces& near : state.contact.pieces) {
        const double gap = least_gap(near, state.trial);
        if (gap < law_of(near).law.skin) ++result.touching;
        result.least_gap = std::min(result.least_gap, gap);
    }
}

}  // namespace gxrod
