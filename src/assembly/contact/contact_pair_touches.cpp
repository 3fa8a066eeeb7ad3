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
    Vec3 point = Vec3::Zero();
    std::array<double, 2> places{};
    double weight = 0.0;
    double gap = std::numeric_limits<double>::infinity();
};

// Where along a piece the resultant of the forces at its ends acts.
double find_fraction(const Vec3& start, const Vec3& end) {
    const Vec3 sum = start + end;
    const double square = sum.squaredNorm();
    return square > 0.0 ? std::clamp(end.dot(sum) / square, 0.0, 1.0) : 0.5;
}

}  // namespace

void ContactPairs::add_touches(const State& state, std::vector<ContactTouch>& touches) const {
    const std::vector<std::size_t> touching = list_touching(state);
    std::vector<PairEnergy> energies(touching.size());
    team_->for_each_range(touching.size(), [&](std::size_t first, std::size_t last) {
        for (std::size_t i = first; i < last; ++i)
            energies[i] = find_energy(state.contact.pieces[touching[i]], state.trial);
    });
    std::map<std::pair<int, int>, ElementTouch> of_elements;
    for (std::size_t i = 0; i < touching.size(); ++i) {
        const NearPieces& near = state.contact.pieces[touching[i]];
        const Vec12 ends = -energies[i].gradient;
        const Vec3 force = ends.segment<3>(0) + ends.segment<3>(3);
        const double weight = force.norm();
        if (weight == 0.0) continue;
        std::array<Vec3, 2> positions;
        std::array<double, 2> radii{};
        std::array<double, 2> places{};
        std::array<int, 2> elements{};
        for (std::size_t side = 0; side < 2; ++side) {
            const std::size_t piece = side == 0 ? near.first : near.second;
            const auto start = static_cast<Eigen::Index>(6 * side);
            const double at = find_fraction(ends.segment<3>(start), ends.segment<3>(start + 3));
            const std::size_t place = lines_.pieces[piece].place;
            const ContactPlace& from = lines_.places.places[place];
            const ContactPlace& to = lines_.places.places[place + 1];
            positions[side] = segment_of(piece, state.trial).at(at);
            places[side] = from.fraction + at * (to.fraction - from.fraction);
            radii[side] = lines_.element_of(lines_.pieces[piece]).radius;
            elements[side] = from.element;
        }
        const Vec3 offset = positions[1] - positions[0];
        const double distance = offset.norm();
        const double half = 0.5 * (distance + radii[0] - radii[1]);
        ElementTouch& own = of_elements[{elements[0], elements[1]}];
        own.force += force;
        own.weight += weight;
        own.point += weight * (positions[0] + (half / distance) * offset);
        for (std::size_t side = 0; side < 2; ++side) own.places[side] += weight * places[side];
        own.gap = std::min(own.gap, least_gap(near, state.trial));
    }
    for (const auto& [elements, own] : of_elements) {
        const auto rod_of = [&](int element) {
            return lines_.places.elements[static_cast<std::size_t>(element)].rod;
        };
        touches.push_back({{rod_of(elements.first), rod_of(elements.second)},
                           {own.places[0] / own.weight, own.places[1] / own.weight},
                           own.point / own.weight,
                           own.force,
                           Vec3::Zero(),
                           own.gap,
                           true});
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
