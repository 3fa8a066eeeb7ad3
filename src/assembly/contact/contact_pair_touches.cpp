#include <algorithm>
#include <limits>
#include <map>

#include "assembly/contact/contact_pairs.hpp"

// Where rods touch each other, for results.
namespace gxrod {

namespace {

// The sum over the pieces of two elements, places and points weighted by their forces.
struct ElementTouch {
    Vec3 force = Vec3::Zero();
    Vec3 friction = Vec3::Zero();
    bool slides = true;
    Vec3 point = Vec3::Zero();
    std::array<double, 2> places{};
    double weight = 0.0;
    double gap = std::numeric_limits<double>::infinity();
};

}  // namespace

void ContactPairs::add_touches(const State& state, std::vector<ContactTouch>& touches) const {
    std::map<std::pair<int, int>, ElementTouch> of_elements;
    for (const Touching& touching : find_touching(state)) {
        const NearPieces& near = state.contact.pieces[touching.index];
        const PairMotion motion = motion_of(near, state);
        const PairPlace at = find_pair_place(touching.energy, motion);
        if (at.force == 0.0) continue;
        std::array<double, 2> places{};
        for (std::size_t side = 0; side < 2; ++side) {
            const ContactPiece& piece = lines_.pieces[side == 0 ? near.first : near.second];
            const double from = lines_.places.places[piece.place].fraction;
            const double to = lines_.places.places[piece.place + 1].fraction;
            places[side] = from + (side == 0 ? at.s : at.t) * (to - from);
        }
        const auto& x = motion.positions;
        const Vec3 position = x[0] + at.s * (x[1] - x[0]);
        const Vec3 offset = x[2] + at.t * (x[3] - x[2]) - position;
        const double distance = offset.norm();
        const double half = 0.5 * (distance + motion.radius_a - motion.radius_b);
        ElementTouch& own = of_elements[{element_of(near.first), element_of(near.second)}];
        own.force += touching.impulse.force();
        own.weight += at.force;
        own.point += at.force * (position + (half / distance) * offset);
        for (std::size_t side = 0; side < 2; ++side) own.places[side] += at.force * places[side];
        own.gap = std::min(own.gap, least_gap(near, state.trial));
        if (!rub()) continue;
        const CoulombFriction friction = friction_of(touching.index, state);
        const Traction rubbing = compute_pair_friction(touching.energy, motion, friction).traction;
        own.friction += rubbing.value;
        // What slides has a traction on the cone, as far as rounding lets it be.
        constexpr double nearly = 1.0 - 1e-9;
        const bool slides = friction.shape != nullptr
                                ? rubbing.slides
                                : rubbing.value.norm() >= nearly * friction.coefficient * at.force;
        own.slides = own.slides && slides;
    }
    for (const auto& [elements, own] : of_elements) {
        const auto rod_of = [&](int element) {
            return lines_.places.elements[static_cast<std::size_t>(element)].rod;
        };
        touches.push_back({{rod_of(elements.first), rod_of(elements.second)},
                           {own.places[0] / own.weight, own.places[1] / own.weight},
                           own.point / own.weight,
                           own.force,
                           own.friction,
                           own.gap,
                           own.slides});
    }
}

void ContactPairs::lower_gaps(const State& state, std::vector<double>& gaps) const {
    for (const NearPieces& near : state.contact.pieces) {
        const ClosestPoints closest =
            find_closest_points(segment_of(near.first, state.trial), segment_of(near.second, state.trial));
        const PairLaw pair = law_of(near);
        const double gap = closest.distance - pair.radii;
        if (gap >= pair.law.skin) continue;
        for (const auto& [index, t] : {std::pair(near.first, closest.s), std::pair(near.second, closest.t)}) {
            const ContactPlace* place = &lines_.places.places[lines_.pieces[index].place];
            double& own = gaps[static_cast<std::size_t>(lines_.places.nearest_node(place[0], place[1], t))];
            own = std::min(own, gap);
        }
    }
}

double ContactPairs::find_least_gap(const ContactWatch& watch, const State& state) const {
    const auto rod_of = [&](std::size_t piece) { return lines_.element_of(lines_.pieces[piece]).rod; };
    const auto is_watched = [&](std::size_t a, std::size_t b) {
        for (const auto& [own, other] : {std::pair(rod_of(a), rod_of(b)), std::pair(rod_of(b), rod_of(a))}) {
            if (own == watch.rod && watch.other.value_or(other) == other) return true;
        }
        return false;
    };
    double least = std::numeric_limits<double>::infinity();
    for (const NearPieces& near : state.contact.pieces) {
        if (is_watched(near.first, near.second)) least = std::min(least, least_gap(near, state.trial));
    }
    // What is not among them is further apart.
    if (least <= state.contact.margin - 2.0 * state.contact.travelled) return least;
    for (std::uint32_t own = 0; own < lines_.pieces.size(); ++own) {
        if (rod_of(own) != watch.rod) continue;
        const Segment a = segment_of(own, state.trial);
        const Vec3 centre = a.at(0.5);
        const double extent = (a.end - centre).norm() + lines_.element_of(lines_.pieces[own]).radius;
        for (std::uint32_t other = 0; other < lines_.pieces.size(); ++other) {
            if (other == own || !is_watched(own, other)) continue;
            const Segment b = segment_of(other, state.trial);
            const double far =
                extent + 0.5 * (b.end - b.start).norm() + lines_.element_of(lines_.pieces[other]).radius;
            if ((b.at(0.5) - centre).norm() - far >= least) continue;
            if (!lines_.can_touch(lines_.pieces[own], lines_.pieces[other])) continue;
            least = std::min(least, least_gap({std::min(own, other), std::max(own, other)}, state.trial));
        }
    }
    return least;
}

}  // namespace gxrod
