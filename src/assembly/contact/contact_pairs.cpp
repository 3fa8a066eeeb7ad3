#include "assembly/contact/contact_pairs.hpp"

#include <algorithm>
#include <map>
#include <numeric>

#include "contact/advancement.hpp"

namespace gxrod {

namespace {

using Ends = std::array<std::size_t, 2>;  // places

// Of sets that are merged.
class Unions {
  public:
    explicit Unions(std::size_t count) : parents_(count) {
        std::iota(parents_.begin(), parents_.end(), std::size_t{0});
    }
    std::size_t find(std::size_t one) {
        while (parents_[one] != one) one = parents_[one] = parents_[parents_[one]];
        return one;
    }
    void merge(std::size_t one, std::size_t other) {
        one = find(one);
        other = find(other);
        parents_[std::max(one, other)] = std::min(one, other);
    }

  private:
    std::vector<std::size_t> parents_;
};

double largest_motion(const Segment& motion) { return std::max(motion.start.norm(), motion.end.norm()); }

Segment add(const Segment& segment, const Segment& motion) {
    return {segment.start + motion.start, segment.end + motion.end};
}

}  // namespace

ContactPairs::ContactPairs(const Model& model, const ThreadTeam& team, const ScaleGroups& groups)
    : model_(&model), team_(&team), groups_(&groups) {
    if (model.contact.radii.empty()) return;
    lines_ = find_contact_lines(model);
    for (ContactElement& element : lines_.places.elements)
        element.part = groups.part_of_node(element.nodes[0]);
}

Segment ContactPairs::segment_of(std::size_t piece, const std::vector<NodeMotion>& motions) const {
    const ContactPlaces& all = lines_.places;
    const std::size_t place = lines_.pieces[piece].place;
    return {all.interpolate(all.places[place], motions, &NodeMotion::r),
            all.interpolate(all.places[place + 1], motions, &NodeMotion::r)};
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
    PairEnergy sum = compute_pair_energy(pair, a, b, of_a.length, of_b.length);
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
    // A point is a segment whose ends are the same.
    const auto add_ends =
        [&](const ContactPiece& piece, const Segment& own, const Segment& other, bool is_first) {
            for (int end = 0; end < 2; ++end) {
                if (!(end == 0 ? piece.starts_rod : piece.ends_rod)) continue;
                const Vec3& point = end == 0 ? own.start : own.end;
                const int at = (is_first ? 0 : 2) + end;
                add(compute_closest_energy(pair, {point, point}, other),
                    {at, at, is_first ? 2 : 0, is_first ? 3 : 1});
            }
        };
    add_ends(of_a, a, b, true);
    add_ends(of_b, b, a, false);
    return sum;
}

std::vector<std::size_t> ContactPairs::list_touching(const State& state) const {
    const std::vector<NearPieces>& near = state.contact.pieces;
    std::vector<char> touches(near.size(), 0);
    team_->for_each_range(near.size(), [&](std::size_t first, std::size_t last) {
        for (std::size_t i = first; i < last; ++i)
            touches[i] = least_gap(near[i], state.trial) < law_of(near[i]).law.skin ? 1 : 0;
    });
    std::vector<std::size_t> listed;
    for (std::size_t i = 0; i < near.size(); ++i) {
        if (touches[i] != 0) listed.push_back(i);
    }
    return listed;
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
    contact.pieces.clear();
    for (const CapsulePair pair : find_near_pairs(capsules, contact.margin, keep)) {
        contact.pieces.push_back({pair.first, pair.second});
    }
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
        elements.emplace_back(lines_.places.places[lines_.pieces[near.first].place].element,
                              lines_.places.places[lines_.pieces[near.second].place].element);
    std::ranges::sort(elements);
    elements.erase(std::ranges::unique(elements).begin(), elements.end());
    std::vector<NodeGroup> groups;
    for (const auto& [a, b] : elements) groups.push_back(list_nodes(a, b));
    return groups;
}

// add(node, force), of both ends of both pieces.
template <class Add>
void ContactPairs::scatter(const NearPieces& near, const Vec12& of_ends, const Add& add) const {
    int end = 0;
    for (const std::uint32_t index : {near.first, near.second}) {
        const ContactPiece& piece = lines_.pieces[index];
        const ContactElement& element = lines_.element_of(piece);
        for (std::size_t p = piece.place; p < piece.place + 2; ++p, ++end) {
            for (int i = 0; i < element.count; ++i)
                add(element.nodes[static_cast<std::size_t>(i)],
                    Vec3(lines_.places.places[p].shapes[static_cast<std::size_t>(i)] *
                         of_ends.segment<3>(3 * end)));
        }
    }
}

void ContactPairs::subtract_forces(const State& state, double weight, Residual& residual) const {
    if (weight == 0.0) return;
    const std::vector<std::size_t> touching = list_touching(state);
    std::vector<PairEnergy> energies(touching.size());
    team_->for_each_range(touching.size(), [&](std::size_t first, std::size_t last) {
        for (std::size_t i = first; i < last; ++i)
            energies[i] = find_energy(state.contact.pieces[touching[i]], state.trial);
    });
    for (std::size_t i = 0; i < touching.size(); ++i) {
        const NearPieces& near = state.contact.pieces[touching[i]];
        scatter(near, -weight * energies[i].gradient, [&](int node, const Vec3& force) {
            Vec6 both = Vec6::Zero();
            both.head<3>() = force;
            residual.raise_group(groups_->of_node(node), both);
            residual.nodal[static_cast<std::size_t>(node)] -= both;
        });
    }
}

std::vector<PairBlock> ContactPairs::compute_tangents(
    const State& state, double weight, const std::vector<NodeLinearization>& linearizations) const {
    const std::vector<std::size_t> touching = list_touching(state);
    std::vector<PairEnergy> energies(touching.size());
    team_->for_each_range(touching.size(), [&](std::size_t first, std::size_t last) {
        for (std::size_t i = first; i < last; ++i)
            energies[i] = find_energy(state.contact.pieces[touching[i]], state.trial);
    });
    std::map<std::pair<int, int>, PairBlock> of_elements;
    for (std::size_t i = 0; i < touching.size(); ++i) {
        const NearPieces& near = state.contact.pieces[touching[i]];
        const int first = lines_.places.places[lines_.pieces[near.first].place].element;
        const int second = lines_.places.places[lines_.pieces[near.second].place].element;
        PairBlock& block = of_elements[{first, second}];
        if (block.nodes.empty()) {
            block.nodes = list_nodes(first, second);
            const auto size = static_cast<Eigen::Index>(6 * block.nodes.size());
            block.matrix = Eigen::MatrixXd::Zero(size, size);
        }
        // Shape functions of the four ends by the group's nodes.
        Eigen::Matrix<double, 4, Eigen::Dynamic> shapes =
            Eigen::Matrix<double, 4, Eigen::Dynamic>::Zero(4, static_cast<Eigen::Index>(block.nodes.size()));
        int end = 0;
        for (const std::uint32_t index : {near.first, near.second}) {
            const ContactPiece& piece = lines_.pieces[index];
            const ContactElement& element = lines_.element_of(piece);
            for (std::size_t p = piece.place; p < piece.place + 2; ++p, ++end) {
                for (int n = 0; n < element.count; ++n) {
                    const auto at =
                        std::ranges::find(block.nodes, element.nodes[static_cast<std::size_t>(n)]);
                    shapes(end, at - block.nodes.begin()) +=
                        lines_.places.places[p].shapes[static_cast<std::size_t>(n)];
                }
            }
        }
        for (Eigen::Index column = 0; column < shapes.cols(); ++column) {
            const double placement =
                linearizations[static_cast<std::size_t>(block.nodes[static_cast<std::size_t>(column)])]
                    .placement;
            for (Eigen::Index row = 0; row < shapes.cols(); ++row) {
                Mat3 sum = Mat3::Zero();
                for (int a = 0; a < 4; ++a) {
                    for (int b = 0; b < 4; ++b)
                        sum += (shapes(a, row) * shapes(b, column)) *
                               energies[i].hessian.block<3, 3>(3 * a, 3 * b);
                }
                block.matrix.block<3, 3>(6 * row, 6 * column) += (weight * placement) * sum;
            }
        }
    }
    std::vector<PairBlock> blocks;
    for (auto& [elements, block] : of_elements) blocks.push_back(std::move(block));
    return blocks;
}

void ContactPairs::limit(const std::vector<Vec3>& displacements, State& state, ContactLimits& limits) const {
    double reach = 0.0;
    for (const Vec3& one : displacements) reach = std::max(reach, one.norm());
    ContactTrial& contact = state.contact;
    double skin = 0.0;
    for (const ContactElement& element : lines_.places.elements) skin = std::max(skin, element.law.skin);
    reach *= largest_shape_sum;
    if (contact.margin == 0.0 || skin + 2.0 * (contact.travelled + reach) > contact.margin)
        search(reach, state);
    double all = 1.0;
    const double room = 0.5 * (contact.margin - skin) - contact.travelled;
    if (reach > room) all = room / reach;
    const auto motion_of = [&](std::size_t piece) -> Segment {
        const ContactElement& element = lines_.element_of(lines_.pieces[piece]);
        Segment motion{Vec3::Zero(), Vec3::Zero()};
        for (int n = 0; n < element.count; ++n) {
            const Vec3& displacement =
                displacements[static_cast<std::size_t>(element.nodes[static_cast<std::size_t>(n)])];
            const auto shape = static_cast<std::size_t>(n);
            motion.start += lines_.places.places[lines_.pieces[piece].place].shapes[shape] * displacement;
            motion.end += lines_.places.places[lines_.pieces[piece].place + 1].shapes[shape] * displacement;
        }
        return motion;
    };
    std::vector<double> of_pairs(contact.pieces.size(), 1.0), gaps(contact.pieces.size());
    std::vector<char> can_meet(contact.pieces.size(), 0);
    team_->for_each_range(of_pairs.size(), [&](std::size_t first, std::size_t last) {
        for (std::size_t i = first; i < last; ++i) {
            const NearPieces& near = contact.pieces[i];
            gaps[i] = least_gap(near, state.trial);
            const Segment a = segment_of(near.first, state.trial);
            const Segment b = segment_of(near.second, state.trial);
            const Segment move_a = motion_of(near.first);
            const Segment move_b = motion_of(near.second);
            if (0.9 * gaps[i] >= largest_motion(move_a) + largest_motion(move_b)) continue;
            can_meet[i] = 1;
            of_pairs[i] = advance_capsules(a, add(a, move_a), b, add(b, move_b), law_of(near).radii).fraction;
        }
    });
    Unions islands(limits.of_parts.size());
    for (std::size_t i = 0; i < of_pairs.size(); ++i) {
        limits.least_gap = std::min(limits.least_gap, gaps[i]);
        if (can_meet[i] == 0) continue;
        const NearPieces& near = contact.pieces[i];
        const auto a = static_cast<std::size_t>(lines_.element_of(lines_.pieces[near.first]).part);
        const auto b = static_cast<std::size_t>(lines_.element_of(lines_.pieces[near.second]).part);
        islands.merge(a, b);
        limits.of_parts[a] = std::min(limits.of_parts[a], of_pairs[i]);
    }
    std::vector<double> of_islands(limits.of_parts.size(), all);
    for (std::size_t part = 0; part < of_islands.size(); ++part) {
        double& island = of_islands[islands.find(part)];
        island = std::min(island, limits.of_parts[part]);
    }
    for (std::size_t part = 0; part < of_islands.size(); ++part) {
        limits.of_parts[part] = of_islands[islands.find(part)];
        limits.least = std::min(limits.least, limits.of_parts[part]);
    }
    contact.travelled += std::min(reach, room);
}

double ContactPairs::compute_energy(const State& state) const {
    double energy = 0.0;
    for (const std::size_t i : list_touching(state))
        energy += find_energy(state.contact.pieces[i], state.trial).energy;
    return energy;
}

double ContactPairs::compute_work(const State& state) const {
    double work = 0.0;
    for (const std::size_t i : list_touching(state)) {
        const NearPieces& near = state.contact.pieces[i];
        const PairEnergy found = find_energy(near, state.trial);
        scatter(near, -found.gradient, [&](int node, const Vec3& of_node) {
            const auto index = static_cast<std::size_t>(node);
            work += of_node.dot(state.trial[index].r - state.previous[index].r);
        });
    }
    return work;
}

void ContactPairs::count(const State& state, ContactCount& result) const {
    for (const NearPieces& near : state.contact.pieces) {
        const double gap = least_gap(near, state.trial);
        if (gap < law_of(near).law.skin) ++result.touching;
        result.least_gap = std::min(result.least_gap, gap);
    }
}

}  // namespace gxrod
