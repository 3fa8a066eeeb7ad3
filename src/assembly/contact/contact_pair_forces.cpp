#include <algorithm>
#include <tuple>

#include "assembly/contact/contact_pairs.hpp"
#include "rotation/tangent_map.hpp"

// Forces of rods that touch each other, with their friction, and what follows from them.
namespace gxrod {

const std::vector<ContactPairs::Touching>& ContactPairs::find_touching(const State& state) const {
    const std::vector<NearPieces>& near = state.contact.pieces;
    PiecesPlaced placed = place_pieces(state);
    const bool has_same_pieces = near == found_.pieces;
    if (has_same_pieces && placed == found_.placed) return found_.touching;
    if (!has_same_pieces || placed.before != found_.placed.before)
        found_.starts.assign(near.size(), std::nullopt);
    found_.pieces = near;
    found_.placed = std::move(placed);
    const PiecesPlaced& at = found_.placed;
    std::vector<char> touches(near.size(), 0);
    team_->for_each_range(near.size(), [&](std::size_t first, std::size_t last) {
        for (std::size_t i = first; i < last; ++i) {
            const PairLaw pair = law_of(near[i]);
            touches[i] =
                are_within(at.now[near[i].first], at.now[near[i].second], pair.radii + pair.law.skin);
        }
    });
    std::vector<Touching>& touching = found_.touching;
    touching.clear();
    for (std::size_t i = 0; i < near.size(); ++i) {
        if (touches[i] != 0) touching.emplace_back().index = i;
    }
    team_->for_each_range(touching.size(), [&](std::size_t first, std::size_t last) {
        for (std::size_t i = first; i < last; ++i) {
            const NearPieces& pieces = near[touching[i].index];
            const double own = at.dampings.empty() ? damping_ : at.dampings[touching[i].index];
            touching[i].energy = touching[i].impulse = find_energy(pieces, at.now);
            if (!at.rates.empty()) {
                const Vec12 rates = find_ends(at.rates[pieces.first], at.rates[pieces.second]);
                PairEnergy& energy = touching[i].energy;
                const double undamped = energy.gradient.dot(rates);
                touching[i].by_rates = damp_by_rates(energy, rates, own);
                touching[i].damping_power = energy.gradient.dot(rates) - undamped;
                touching[i].impulse = energy;
            }
            if (!has_impacts_) continue;
            const Segment &a = at.now[pieces.first], &b = at.now[pieces.second];
            std::optional<PairStart>& start = found_.starts[touching[i].index];
            if (!start) start = find_start(pieces, at.before);
            turn_impulse(a, b, open_ends(pieces), *start, law_of(pieces).radii, touching[i].impulse);
            const Vec12 way = find_ends(a, b) - start->ends;
            const double damping = at.dampings.empty() ? at.damping : own;
            if (damping > 0.0) {
                for (PairEnergy* one : {&touching[i].energy, &touching[i].impulse}) damp(*one, way, damping);
            }
            if (at.drag > 0.0) add_drag(touching[i].impulse, *start, way, at.drag);
        }
    });
    return touching;
}

PairMotion ContactPairs::motion_of(const NearPieces& near, const State& state) const {
    const ContactPlaces& all = lines_.places;
    const PiecesPlaced& placed = found_.placed;
    const auto ends_of = [&](const std::vector<Segment>& segments) -> std::array<Vec3, 4> {
        const Segment &a = segments[near.first], &b = segments[near.second];
        return {a.start, a.end, b.start, b.end};
    };
    // Before is asked for only where there is friction.
    PairMotion motion{ends_of(placed.now), ends_of(placed.before.empty() ? placed.now : placed.before), {}};
    std::size_t end = 0;
    for (const std::uint32_t index : {near.first, near.second}) {
        const ContactPiece& piece = lines_.pieces[index];
        (end == 0 ? motion.radius_a : motion.radius_b) = lines_.element_of(piece).radius;
        for (std::size_t p = piece.place; p < piece.place + 2; ++p, ++end)
            motion.rotations[end] = all.interpolate(all.places[p], state.trial, &NodeMotion::theta);
    }
    return motion;
}

double ContactPairs::coefficient_of(const NearPieces& near) const {
    const ContactException* one =
        lines_.find_exception(lines_.pieces[near.first], lines_.pieces[near.second]);
    return one != nullptr ? one->friction.value_or(model_->contact.friction) : model_->contact.friction;
}

// What sticks is as stiff for parallel rods, however short their pieces are.
double ContactPairs::friction_stiffness_of(const NearPieces& near) const {
    const PairLaw pair = law_of(near);
    return pair.law.stiffness / pair.law.skin * find_share_of_crossing(near);
}

CoulombFriction ContactPairs::friction_of(std::size_t index, const State& state) const {
    const NearPieces& near = state.contact.pieces[index];
    CoulombFriction friction{coefficient_of(near), friction_stiffness_of(near)};
    const std::vector<PairTraction>& memory = state.pair_tractions;
    const auto own = std::ranges::lower_bound(memory, near, {}, &PairTraction::pieces);
    if (own != memory.end() && own->pieces == near) friction.traction = own->traction;
    set_friction_shape(near, state, friction);
    return friction;
}

void ContactPairs::set_friction_shape(const NearPieces& near,
                                      const State& state,
                                      CoulombFriction& friction) const {
    const ContactException* one =
        lines_.find_exception(lines_.pieces[near.first], lines_.pieces[near.second]);
    const FrictionShape& shape =
        one != nullptr && one->friction ? one->friction_shape : model_->contact.friction_shape;
    if (shape.is_plain()) return;
    friction.shape = &shape;
    if (has_impacts_ || resolves_) friction.elapsed = state.trial_time - state.time;
    if (!shape.is_directed()) return;
    const auto find_axis = [&](std::uint32_t index, const std::vector<Segment>& segments) -> Vec3 {
        if (lines_.element_of(lines_.pieces[index]).is_body) return Vec3::Zero();
        return (segments[index].end - segments[index].start).normalized();
    };
    friction.axes = {find_axis(near.first, found_.placed.now),
                     Vec3(-find_axis(near.second, found_.placed.now))};
}

CoulombFriction ContactPairs::taken_friction_of(std::size_t index, const State& state) const {
    CoulombFriction friction = friction_of(index, state);
    friction.direction = state.contact.pieces_sliding[index];
    friction.slip = friction.direction.isZero(0.0) ? Slip::sticks : Slip::slides;
    return friction;
}

void ContactPairs::keep_slip(std::size_t index, const CoulombFriction& friction, State& state) const {
    state.contact.pieces_sliding[index] =
        friction.slip == Slip::slides ? friction.direction : Vec3(Vec3::Zero());
}

template <class Add>
void ContactPairs::scatter(const NearPieces& near,
                           const Vec24& of_ends,
                           const State& state,
                           const Add& add) const {
    int end = 0;
    for (const std::uint32_t index : {near.first, near.second}) {
        const ContactPiece& piece = lines_.pieces[index];
        const ContactElement& element = lines_.element_of(piece);
        for (std::size_t p = piece.place; p < piece.place + 2; ++p, ++end) {
            if (element.is_body) {
                Vec6 force = of_ends.segment<6>(6 * end);
                force.tail<3>() +=
                    lines_.places.lever(lines_.places.places[p], state, has_impacts_).cross(force.head<3>());
                add(element.nodes[0], force);
                continue;
            }
            for (int i = 0; i < element.count; ++i)
                add(element.nodes[static_cast<std::size_t>(i)],
                    Vec6(lines_.places.places[p].shapes[static_cast<std::size_t>(i)] *
                         of_ends.segment<6>(6 * end)));
        }
    }
}

void ContactPairs::subtract_forces(const State& state, double weight, Residual& residual) const {
    if (weight == 0.0) return;
    for (const Touching& touching : find_touching(state)) {
        const NearPieces& near = state.contact.pieces[touching.index];
        Vec24 forces = with_moments(-touching.impulse.gradient);
        if (rub())
            forces += compute_pair_friction(
                          touching.energy, motion_of(near, state), friction_of(touching.index, state))
                          .forces;
        scatter(near, weight * forces, state, [&](int node, const Vec6& force) {
            residual.raise_group(groups_->of_node(node), force);
            residual.nodal[static_cast<std::size_t>(node)] -= force;
        });
    }
}

std::optional<ContactPairs::Expected> ContactPairs::find_expected(std::size_t index,
                                                                  const State& state) const {
    const double zeta = state.contact.pieces_expected[index];
    if (zeta <= no_contact) return std::nullopt;
    const NearPieces& near = state.contact.pieces[index];
    const ClosestPoints closest =
        find_closest_points(segment_of(near.first, state.trial), segment_of(near.second, state.trial));
    const ContactGraphPoint point =
        continue_contact(expected_law_of(near), zeta, closest.distance - law_of(near).radii);
    const Vec3 n = closest.offset / closest.distance;
    Expected result{point.force, point.stiffness, {}};
    result.slope << (1.0 - closest.s) * n, closest.s * n, (closest.t - 1.0) * n, -closest.t * n;
    return result;
}

void ContactPairs::replace_by_tangent_forces(const State& state, double weight, Residual& residual) const {
    if (weight == 0.0) return;
    const auto subtract = [&](const NearPieces& near, const Vec24& forces) {
        scatter(near, weight * forces, state, [&](int node, const Vec6& force) {
            residual.nodal[static_cast<std::size_t>(node)] -= force;
        });
    };
    for (std::size_t index = 0; index < state.contact.pieces.size(); ++index) {
        if (const std::optional<Expected> expected = find_expected(index, state))
            subtract(state.contact.pieces[index], with_moments(expected->force * expected->slope));
    }
    for (const Touching& touching : find_touching(state)) {
        const NearPieces& near = state.contact.pieces[touching.index];
        const bool is_expected = state.contact.pieces_expected[touching.index] > no_contact;
        if (is_expected) subtract(near, with_moments(touching.impulse.gradient));
        if (!rub()) continue;
        const PairMotion motion = motion_of(near, state);
        const auto forces = [&](const CoulombFriction& friction) {
            return compute_pair_friction(touching.energy, motion, friction).forces;
        };
        Vec24 change = -forces(friction_of(touching.index, state));
        if (!is_expected) change += forces(taken_friction_of(touching.index, state));
        subtract(near, change);
    }
}

ContactPairs::Shares ContactPairs::find_shares(const NearPieces& near, const NodeGroup& nodes) const {
    Shares shares = Shares::Zero(4, static_cast<Eigen::Index>(nodes.size()));
    int end = 0;
    for (const std::uint32_t index : {near.first, near.second}) {
        const ContactPiece& piece = lines_.pieces[index];
        const ContactElement& element = lines_.element_of(piece);
        for (std::size_t p = piece.place; p < piece.place + 2; ++p, ++end) {
            for (int n = 0; n < element.count; ++n) {
                const auto at = std::ranges::find(nodes, element.nodes[static_cast<std::size_t>(n)]);
                shares(end, at - nodes.begin()) +=
                    lines_.places.places[p].shapes[static_cast<std::size_t>(n)];
            }
        }
    }
    return shares;
}

std::vector<ContactPairs::Tangible> ContactPairs::list_tangible(const State& state) const {
    const std::vector<Touching>& touching = find_touching(state);
    const std::vector<NearPieces>& pieces = state.contact.pieces;
    std::vector<Tangible> those;
    auto next = touching.begin();
    for (std::size_t index = 0; index < pieces.size(); ++index) {
        const bool touches = next != touching.end() && next->index == index;
        if (touches || state.contact.pieces_expected[index] > no_contact) {
            const std::pair elements(element_of(pieces[index].first), element_of(pieces[index].second));
            those.push_back({elements, index, touches ? &*next : nullptr});
        }
        if (touches) ++next;
    }
    std::ranges::sort(those, {}, [](const Tangible& one) { return std::tie(one.elements, one.index); });
    return those;
}

ContactPairs::EndTangent ContactPairs::find_end_tangent(const Tangible& one, const State& state) const {
    EndTangent own;
    own.index = one.index;
    const auto subtract_by_positions = [&](const Mat12& hessian, Mat24& derivative) {
        for (int a = 0; a < 4; ++a)
            for (int b = 0; b < 4; ++b)
                derivative.block<3, 3>(6 * a, 6 * b) -= hessian.block<3, 3>(3 * a, 3 * b);
    };
    if (const std::optional<Expected> expected = find_expected(one.index, state)) {
        subtract_by_positions(expected->stiffness * expected->slope * expected->slope.transpose(),
                              own.derivative);
        own.forces = with_moments(expected->force * expected->slope);
        return own;
    }
    const NearPieces& near = state.contact.pieces[one.index];
    subtract_by_positions(one.touching->impulse.hessian, own.derivative);
    if (!found_.placed.rates.empty()) {
        const Vec12& G = one.touching->energy.gradient;
        subtract_by_positions(one.touching->by_rates * G * G.transpose(), own.by_rates);
    }
    const bool needs_forces = has_body(near);
    if (needs_forces) own.forces = with_moments(-one.touching->impulse.gradient);
    if (!rub()) return own;
    const CoulombFriction friction =
        state.contact.has_parameters ? taken_friction_of(one.index, state) : friction_of(one.index, state);
    const PairMotion motion = motion_of(near, state);
    own.derivative += compute_pair_friction_derivative(one.touching->energy, motion, friction);
    if (needs_forces) own.forces += compute_pair_friction(one.touching->energy, motion, friction).forces;
    return own;
}

PairBlock ContactPairs::compute_block(std::span<const Tangible> those,
                                      const State& state,
                                      double weight,
                                      const std::vector<NodeLinearization>& linearizations) const {
    PairBlock block{list_nodes(those[0].elements.first, those[0].elements.second), {}};
    const auto size = static_cast<Eigen::Index>(6 * block.nodes.size());
    block.matrix = Eigen::MatrixXd::Zero(size, size);
    const bool with_body = has_body(state.contact.pieces[those[0].index]);
    const double placement = linearizations.front().placement;
    for (const Tangible& one : those) {
        EndTangent tangent = find_end_tangent(one, state);
        // All nodes have the same rates by placements, but for turns of bodies in a step.
        if (!found_.placed.rates.empty())
            tangent.derivative =
                placement * tangent.derivative + linearizations.front().rate * tangent.by_rates;
        const Shares shares = find_shares(state.contact.pieces[one.index], block.nodes);
        if (with_body) {
            add_tangent_with_body(tangent, weight, linearizations, state, shares, block);
            continue;
        }
        for (Eigen::Index column = 0; column < shares.cols(); ++column) {
            for (int b = 0; b < 4; ++b) {
                if (shares(b, column) == 0.0) continue;
                for (Eigen::Index row = 0; row < shares.cols(); ++row) {
                    for (int a = 0; a < 4; ++a) {
                        const double share = shares(a, row) * shares(b, column);
                        if (share != 0.0)
                            block.matrix.block<6, 6>(6 * row, 6 * column) -=
                                share * tangent.derivative.block<6, 6>(6 * a, 6 * b);
                    }
                }
            }
        }
    }
    if (with_body) return block;
    for (std::size_t i = 0; i < block.nodes.size(); ++i) {
        const auto node = static_cast<std::size_t>(block.nodes[i]);
        auto columns = block.matrix.middleCols<6>(6 * static_cast<Eigen::Index>(i));
        columns *= weight * (found_.placed.rates.empty() ? linearizations[node].placement : 1.0);
        if (rub())
            columns.rightCols<3>() =
                (columns.rightCols<3>() * tangent_map_inverse(state.trial[node].theta)).eval();
    }
    return block;
}

std::vector<PairBlock> ContactPairs::compute_tangents(
    const State& state, double weight, const std::vector<NodeLinearization>& linearizations) const {
    const std::vector<Tangible> those = list_tangible(state);
    std::vector<std::span<const Tangible>> of_elements;
    for (std::size_t first = 0, end = 0; first < those.size(); first = end) {
        while (end < those.size() && those[end].elements == those[first].elements) ++end;
        of_elements.emplace_back(&those[first], end - first);
    }
    std::vector<PairBlock> blocks(of_elements.size());
    team_->for_each_range(blocks.size(), [&](std::size_t first, std::size_t last) {
        for (std::size_t i = first; i < last; ++i)
            blocks[i] = compute_block(of_elements[i], state, weight, linearizations);
    });
    return blocks;
}

void ContactPairs::start(State& state) const {
    if (has_impacts_) {
        state.contact.drag = 0.0;
        state.contact.energy_before = compute_energy_before(state);
    }
    if (!rub()) return;
    state.contact.pieces_sliding.assign(state.contact.pieces.size(), Vec3::Zero());
    for (const Touching& touching : find_touching(state)) {
        const PairMotion motion = motion_of(state.contact.pieces[touching.index], state);
        keep_slip(touching.index,
                  advance_pair_slip(touching.energy, motion, {}, friction_of(touching.index, state)),
                  state);
    }
}

void ContactPairs::advance(const std::vector<Vec6>& deltas, State& state) const {
    if (!rub()) return;
    const std::vector<Touching>& touching = find_touching(state);
    const std::vector<NearPieces>& pieces = state.contact.pieces;
    const std::vector<Segment> segments = find_segments(state.trial);
    const double reach = 2.0 * find_reach(deltas);
    team_->for_each_range(pieces.size(), [&](std::size_t first, std::size_t last) {
        auto next = std::ranges::lower_bound(touching, first, {}, &Touching::index);
        for (std::size_t index = first; index < last; ++index) {
            const bool touches = next != touching.end() && next->index == index;
            const PairEnergy energy = touches ? next->energy : PairEnergy();
            if (touches) ++next;
            const NearPieces& near = pieces[index];
            const PairLaw pair = law_of(near);
            // What cannot come to touch now.
            if (!touches &&
                !are_within(
                    segments[near.first], segments[near.second], pair.radii + pair.law.skin + reach)) {
                state.contact.pieces_sliding[index].setZero();
                continue;
            }
            keep_slip(index,
                      advance_pair_slip(energy,
                                        motion_of(near, state),
                                        find_increment(near, deltas, state),
                                        taken_friction_of(index, state)),
                      state);
        }
    });
}

PairIncrement ContactPairs::find_increment(const NearPieces& near,
                                           const std::vector<Vec6>& deltas,
                                           const State& state) const {
    PairIncrement increment;
    std::size_t end = 0;
    for (const std::uint32_t one : {near.first, near.second}) {
        const ContactPiece& piece = lines_.pieces[one];
        const ContactElement& element = lines_.element_of(piece);
        for (std::size_t p = piece.place; p < piece.place + 2; ++p, ++end) {
            increment.displacements[end] = lines_.places.change(lines_.places.places[p], state, deltas);
            for (std::size_t n = 0; n < static_cast<std::size_t>(element.count); ++n) {
                const auto node = static_cast<std::size_t>(element.nodes[n]);
                const double share = lines_.places.places[p].shapes[n];
                if (share == 0.0) continue;
                increment.turns[end] +=
                    share * (tangent_map_inverse(state.trial[node].theta) * deltas[node].tail<3>());
            }
        }
    }
    return increment;
}

void ContactPairs::commit(State& state) const {
    if (rub()) keep_tractions(state);
    // What rubs depends on those of the step before.
    if (bounces()) keep_speeds(state);
}

void ContactPairs::keep_tractions(State& state) const {
    std::vector<PairTraction> memory;
    for (const Touching& touching : find_touching(state)) {
        const NearPieces& near = state.contact.pieces[touching.index];
        const PairFriction there = compute_pair_friction(
            touching.energy, motion_of(near, state), friction_of(touching.index, state));
        if (!there.traction.value.isZero(0.0)) memory.push_back({near, there.traction.value});
    }
    state.pair_tractions = std::move(memory);
}

}  // namespace gxrod
