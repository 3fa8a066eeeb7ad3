#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>

#include "assembly/contact/contact_assembly.hpp"

// What is in something else where a run starts.
namespace gxrod {

namespace {

// Keeps the deepest of each pair.
void keep_deepest(const ContactOverlap& one, std::map<std::array<int, 2>, ContactOverlap>& deepest) {
    const auto [found, is_new] = deepest.emplace(one.rods, one);
    if (!is_new && one.gap < found->second.gap) found->second = one;
}

// Of a rod, a body or an obstacle, as ContactTouch numbers them.
const std::string& find_name(int index, const Model& model) {
    if (index < 0) return model.contact.obstacles[static_cast<std::size_t>(-1 - index)].name;
    const auto part = static_cast<std::size_t>(index);
    return part < model.rods.size() ? model.rods[part].name : model.bodies[part - model.rods.size()].name;
}

// "capsule 2 of ": a shape of a body that has several.
std::string name_shape(int shape, const Contact& contact) {
    if (shape < 0) return "";
    const ContactBody& own = contact.bodies[static_cast<std::size_t>(shape)];
    const auto is_sphere = [](const ContactBody& one) { return one.ends[0] == one.ends[1]; };
    int all = 0, alike = 0, number = 0;
    for (const ContactBody& one : contact.bodies) {
        if (one.body != own.body) continue;
        ++all;
        if (is_sphere(one) == is_sphere(own)) ++alike;
        if (&one == &own) number = alike;
    }
    if (all == 1) return "";
    const char* kind = is_sphere(own) ? "sphere" : "capsule";
    return alike == 1 ? fmt::format("{} of ", kind) : fmt::format("{} {} of ", kind, number);
}

// One side of an overlap.
std::string name_side(const ContactOverlap& one, std::size_t side, const Model& model) {
    return name_shape(one.shapes[side], model.contact) + find_name(one.rods[side], model);
}

// "b and c by 0.00012": a further pair of the list.
std::string name_pair(const ContactOverlap& one, const Model& model) {
    const std::string first = name_side(one, 0, model), second = name_side(one, 1, model);
    if (std::isinf(one.gap)) return fmt::format("{} crosses {}", first, second);
    return one.rods[0] == one.rods[1] ? fmt::format("{} itself by {:.2g}", first, -one.gap)
                                      : fmt::format("{} and {} by {:.2g}", first, second, -one.gap);
}

std::string describe_deepest(const ContactOverlap& one, const Model& model) {
    const auto place = [&](std::size_t side) {
        const std::string name = name_side(one, side, model);
        const bool is_rod = one.rods[side] < static_cast<int>(model.rods.size());
        return is_rod ? fmt::format("{}@{:.4g}", name, one.places[side]) : name;
    };
    if (one.rods[1] >= 0)
        return fmt::format("{} and {} overlap: they are {:.6g} apart, and their radii add up to {:.6g}",
                           place(0),
                           place(1),
                           one.radii + one.gap,
                           one.radii);
    if (std::isinf(one.gap))
        return fmt::format("{} crosses {}obstacle \"{}\"; expected a gap, as small as you like",
                           place(0),
                           one.triangle,
                           model.contact.obstacles[static_cast<std::size_t>(-1 - one.rods[1])].name);
    return fmt::format("{} is {} {}obstacle \"{}\"; expected a gap, as small as you like",
                       place(0),
                       one.gap == 0.0 ? "exactly on" : fmt::format("{:.4g} deep in", -one.gap),
                       one.triangle,
                       model.contact.obstacles[static_cast<std::size_t>(-1 - one.rods[1])].name);
}

}  // namespace

void ContactPairs::add_overlaps(const State& state, std::vector<ContactOverlap>& overlaps) const {
    for (const NearPieces& near : state.contact.pieces) {
        const double gap = least_gap(near, state.trial);
        if (gap > 0.0) continue;
        const auto fraction = [&](std::uint32_t index) {
            const ContactPiece& piece = lines_.pieces[index];
            const ContactElement& element = lines_.element_of(piece);
            const int rod = element.rod;
            return element.is_body ? 0.0 : piece.middle / model_->rods[static_cast<std::size_t>(rod)].length;
        };
        overlaps.push_back({{lines_.element_of(lines_.pieces[near.first]).rod,
                             lines_.element_of(lines_.pieces[near.second]).rod},
                            {fraction(near.first), fraction(near.second)},
                            gap,
                            law_of(near).radii,
                            "",
                            {lines_.element_of(lines_.pieces[near.first]).shape,
                             lines_.element_of(lines_.pieces[near.second]).shape}});
    }
}

std::vector<ContactOverlap> ContactAssembly::list_overlaps(const State& state, double time) const {
    const At at = find_obstacles(state, time, 1.0);
    std::map<std::array<int, 2>, ContactOverlap> deepest;
    for (std::size_t p = 0; p < places_.places.size(); ++p) {
        const ContactPlace& place = places_.places[p];
        const ContactElement& element = places_.elements[static_cast<std::size_t>(place.element)];
        const Vec3 position = places_.position(place, state.trial);
        const Vec3 next =
            p + 1 < element.end_place ? places_.position(places_.places[p + 1], state.trial) : position;
        for (std::size_t s = 0; s < surfaces_.size(); ++s) {
            const ObstacleSurface& surface = surfaces_[s];
            if (surface.body->stiffness || is_off(s, p)) continue;
            ContactOverlap own{{element.rod, -1 - static_cast<int>(surface.obstacle)}, {place.fraction, 0.0}};
            own.shapes[0] = element.shape;
            if (const std::optional<int> crossed = surface.find_crossed(at.now[s], position, next)) {
                own.gap = -std::numeric_limits<double>::infinity();
                own.triangle = fmt::format("triangle {} of ", *crossed);
            } else {
                own.gap = touch(at, s, p, position).gap;
                if (own.gap > 0.0) continue;
                own.triangle = surface.name_triangle(at.now[s], position);
            }
            keep_deepest(own, deepest);
        }
    }
    std::vector<ContactOverlap> of_rods;
    pairs_.add_overlaps(state, of_rods);
    for (const ContactOverlap& one : of_rods) keep_deepest(one, deepest);
    std::vector<ContactOverlap> all;
    for (const auto& [rods, one] : deepest) all.push_back(one);
    std::ranges::stable_sort(all, {}, &ContactOverlap::gap);
    return all;
}

std::string ContactAssembly::describe_overlap(const State& state, double time) const {
    constexpr std::size_t most_named = 6;
    const std::vector<ContactOverlap> all = list_overlaps(state, time);
    if (all.empty()) return "";
    std::string text = describe_deepest(all[0], *model_);
    const std::size_t named = std::min(all.size(), most_named);
    for (std::size_t i = 1; i < named; ++i) {
        text += i > 1             ? ", "
                : all.size() == 2 ? "; 1 more pair overlaps: "
                                  : fmt::format("; {} more pairs overlap: ", all.size() - 1);
        text += name_pair(all[i], *model_);
    }
    return all.size() > named ? text + fmt::format(" and {} that are less deep", all.size() - named) : text;
}

}  // namespace gxrod
