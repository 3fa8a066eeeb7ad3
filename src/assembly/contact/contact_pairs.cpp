#include "assembly/contact/contact_pairs.hpp"

#include <algorithm>
#include <cmath>
#include <set>

#include "rotation/rotation_map.hpp"

namespace gxrod {

namespace {

// What is kept of each piece, from one list of near pieces to the next.
template <class Value>
std::vector<Value> carry_over(const std::vector<NearPieces>& before,
                              const std::vector<Value>& values,
                              const std::vector<NearPieces>& after,
                              const Value& none) {
    std::vector<Value> carried(after.size(), none);
    if (values.size() != before.size()) return carried;
    for (std::size_t i = 0; i < after.size(); ++i) {
        const auto own = std::ranges::lower_bound(before, after[i]);
        if (own != before.end() && *own == after[i])
            carried[i] = values[static_cast<std::size_t>(own - before.begin())];
    }
    return carried;
}

}  // namespace

ContactPairs::ContactPairs(const Model& model,
                           const ThreadTeam& team,
                           const ScaleGroups& groups,
                           bool is_for_small_motions)
    : model_(&model), team_(&team), groups_(&groups) {
    if (model.contact.radii.empty() && model.contact.bodies.empty()) return;
    lines_ = find_contact_lines(model);
    rubs_ = model.contact.friction > 0.0;
    has_impacts_ = model.has_inertia && model.has_time && !is_for_small_motions;
    if (has_impacts_) damping_ = model.contact.damping;
    for (const ContactException& one : model.contact.exceptions)
        rubs_ = rubs_ || one.friction.value_or(0.0) > 0.0;
    find_restitutions();
    for (ContactElement& element : lines_.places.elements)
        element.part = groups.part_of_node(element.nodes[0]);
}

Segment ContactPairs::segment_of(std::size_t piece, const std::vector<NodeMotion>& motions) const {
    const ContactPlaces& all = lines_.places;
    const std::size_t place = lines_.pieces[piece].place;
    return {all.position(all.places[place], motions), all.position(all.places[place + 1], motions)};
}

std::vector<Segment> ContactPairs::find_segments(const std::vector<NodeMotion>& motions) const {
    // Most places end one piece and start the next.
    std::vector<Vec3> positions(lines_.places.places.size());
    team_->for_each_range(positions.size(), [&](std::size_t first, std::size_t last) {
        for (std::size_t i = first; i < last; ++i)
            positions[i] = lines_.places.position(lines_.places.places[i], motions);
    });
    std::vector<Segment> segments(lines_.pieces.size());
    for (std::size_t i = 0; i < segments.size(); ++i) {
        const std::size_t place = lines_.pieces[i].place;
        segments[i] = {positions[place], positions[place + 1]};
    }
    return segments;
}

std::vector<Segment> ContactPairs::find_rates(const std::vector<NodeMotion>& motions) const {
    const ContactPlaces& all = lines_.places;
    std::vector<Segment> rates(lines_.pieces.size());
    team_->for_each_range(rates.size(), [&](std::size_t first, std::size_t last) {
        for (std::size_t i = first; i < last; ++i) {
            const std::size_t place = lines_.pieces[i].place;
            rates[i] = {all.velocity(all.places[place], motions),
                        all.velocity(all.places[place + 1], motions)};
        }
    });
    return rates;
}

PairLaw ContactPairs::law_of(const NearPieces& near) const {
    const ContactElement& a = lines_.element_of(lines_.pieces[near.first]);
    const ContactElement& b = lines_.element_of(lines_.pieces[near.second]);
    // A crossing of the weaker of the two at half the skin carries a thousandth of its EA.
    return {a.radius + b.radius,
            {std::min(a.law.skin, b.law.skin),
             2.0 * std::min(a.law.stiffness * a.radius, b.law.stiffness * b.radius)}};
}

ContactPairs::PiecesPlaced ContactPairs::place_pieces(const State& state) const {
    PiecesPlaced placed;
    placed.now = find_segments(state.trial);
    if (has_impacts_ || rub()) placed.before = find_segments(state.previous);
    if (resolves_ && (damping_ > 0.0 || bounces())) placed.rates = find_rates(state.trial);
    if (bounces() && (has_impacts_ || resolves_)) placed.dampings = find_dampings(state);
    if (!has_impacts_) return placed;
    const double elapsed = state.trial_time - state.time;
    if (elapsed > 0.0) placed.damping = damping_ / elapsed;
    placed.drag = state.contact.drag;
    return placed;
}

PairEnergy ContactPairs::find_energy(const NearPieces& near, const std::vector<Segment>& segments) const {
    const PairLaw pair = law_of(near);
    const ContactPiece& of_a = lines_.pieces[near.first];
    const ContactPiece& of_b = lines_.pieces[near.second];
    const Segment& a = segments[near.first];
    const Segment& b = segments[near.second];
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
    const auto is_end = [](const ContactPiece& piece, int end) {
        return end == 0 ? piece.starts_rod : piece.ends_rod;
    };
    const auto point_of = [](const Segment& segment, int end) -> const Vec3& {
        return end == 0 ? segment.start : segment.end;
    };
    for (int end = 0; end < 2; ++end) {
        if (of_b.length > 0.0 && is_end(of_a, end))
            add(compute_point_energy(pair, point_of(a, end), b, of_b.length), {end, end, 2, 3});
        if (of_a.length > 0.0 && is_end(of_b, end))
            add(compute_point_energy(pair, point_of(b, end), a, of_a.length), {2 + end, 2 + end, 0, 1});
        // A sphere and the end of a line have enough with these.
        if ((of_a.length > 0.0) != (of_b.length > 0.0)) continue;
        for (int other = 0; other < 2; ++other) {
            if (!is_end(of_a, end) || !is_end(of_b, other)) continue;
            add(compute_points_energy(pair, point_of(a, end), point_of(b, other)),
                {end, end, 2 + other, 2 + other});
        }
    }
    return sum;
}

double ContactPairs::find_share_of_crossing(const NearPieces& near) const {
    const PairLaw pair = law_of(near);
    const double reach = std::sqrt(pair.law.skin * (2.0 * pair.radii + pair.law.skin));
    double length = reach;
    for (const std::uint32_t one : {near.first, near.second}) {
        const ContactPiece& piece = lines_.pieces[one];
        if (!lines_.element_of(piece).is_body) length = std::min(length, piece.length);
    }
    return length / reach;
}

double ContactPairs::largest_skin() const {
    double skin = 0.0;
    for (const ContactElement& element : lines_.places.elements) skin = std::max(skin, element.law.skin);
    return skin;
}

double ContactPairs::find_reach(const std::vector<Vec6>& increments) const {
    double reach = 0.0;
    for (const Vec6& one : increments) reach = std::max(reach, one.head<3>().norm());
    reach *= largest_shape_sum;
    for (auto element = lines_.places.elements.rbegin();
         element != lines_.places.elements.rend() && element->is_body;
         ++element)
        reach = std::max(reach, lines_.places.reach(*element, increments));
    return reach;
}

double ContactPairs::least_gap(const NearPieces& near, const std::vector<NodeMotion>& motions) const {
    return find_closest_points(segment_of(near.first, motions), segment_of(near.second, motions)).distance -
           law_of(near).radii;
}

void ContactPairs::search(double reach, State& state) const {
    double thickest = 0.0;
    std::vector<Capsule> capsules(lines_.pieces.size());
    const std::vector<Segment> segments = find_segments(state.trial);
    for (std::size_t i = 0; i < capsules.size(); ++i) {
        const double radius = lines_.element_of(lines_.pieces[i]).radius;
        capsules[i] = {segments[i].start, segments[i].end, radius};
        thickest = std::max(thickest, radius);
    }
    ContactTrial& contact = state.contact;
    // Motions beyond that are shortened.
    contact.margin = largest_skin() + 2.0 * std::clamp(reach, 0.25 * thickest, 4.0 * thickest);
    contact.travelled = 0.0;
    const auto keep = [&](CapsulePair pair) {
        return lines_.can_touch(lines_.pieces[pair.first], lines_.pieces[pair.second]);
    };
    const std::vector<NearPieces> before = std::move(contact.pieces);
    contact.pieces.clear();
    for (const CapsulePair pair : find_near_pairs(capsules, contact.margin, keep)) {
        contact.pieces.push_back({pair.first, pair.second});
    }
    contact.pieces_expected = carry_over(before, contact.pieces_expected, contact.pieces, no_contact);
    if (rub())
        contact.pieces_sliding =
            carry_over(before, contact.pieces_sliding, contact.pieces, Vec3(Vec3::Zero()));
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
    const std::vector<Segment> segments = find_segments(state.trial);
    for (std::size_t i = 0; i < state.contact.pieces.size(); ++i) {
        const NearPieces& near = state.contact.pieces[i];
        // Others that come to touch within the step are added then.
        const PairLaw pair = law_of(near);
        if (state.contact.pieces_expected[i] > no_contact ||
            are_within(segments[near.first], segments[near.second], pair.radii + 2.0 * pair.law.skin))
            elements.emplace_back(element_of(near.first), element_of(near.second));
    }
    std::ranges::sort(elements);
    elements.erase(std::ranges::unique(elements).begin(), elements.end());
    std::vector<NodeGroup> groups;
    for (const auto& [a, b] : elements) groups.push_back(list_nodes(a, b));
    if (model_->contact.bodies.empty()) return groups;
    // Shapes of a body have the same node.
    std::set<NodeGroup> listed;
    std::erase_if(groups, [&](const NodeGroup& group) { return !listed.insert(group).second; });
    return groups;
}

void ContactPairs::count(const State& state, ContactCount& result) const {
    const std::vector<Segment> segments = find_segments(state.trial);
    for (const NearPieces& near : state.contact.pieces) {
        const double gap =
            find_closest_points(segments[near.first], segments[near.second]).distance - law_of(near).radii;
        if (gap < law_of(near).law.skin) ++result.touching;
        result.least_gap = std::min(result.least_gap, gap);
    }
}

}  // namespace gxrod
