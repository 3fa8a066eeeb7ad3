#include "model/ties/ties.hpp"

#include <fmt/format.h>

#include <cassert>
#include <cmath>
#include <iterator>

#include "model/ties/yielding_supports.hpp"

namespace gxrod {

namespace {

std::array<Anchor, 2> ends_of(const Model&, const auto& element) { return element.ends; }

std::array<Anchor, 2> ends_of(const Model&, const Joint& joint) { return {joint.a.anchor, joint.b.anchor}; }

std::array<Anchor, 2> ends_of(const Model& model, const Gear& gear) {
    const auto moved = [&](const GearSide& side) {
        return model.joints[static_cast<std::size_t>(side.joint)].moving_anchor();
    };
    return {moved(gear.sides[0]), moved(gear.sides[1])};
}

std::array<Anchor, 2> ends_of(const Model& model, const Sleeve& sleeve) {
    const Rod& rod = model.rods[static_cast<std::size_t>(sleeve.rod)];
    return {Anchor{.node = rod.nodes.front()}, sleeve.point};
}

}  // namespace

std::vector<Tie> list_ties(const Model& model, TieKind kind) {
    std::vector<Tie> ties;
    for_each_tie_list(model, [&](TieKind of_list, const auto& list) {
        if (of_list != kind) return;
        for (std::size_t i = 0; i < list.size(); ++i)
            ties.push_back({kind, i, &list[i].name, ends_of(model, list[i])});
    });
    return ties;
}

std::vector<Tie> list_ties(const Model& model) {
    std::vector<Tie> all;
    for (std::size_t kind = 0; kind < tie_kind_count; ++kind)
        std::ranges::copy(list_ties(model, static_cast<TieKind>(kind)), std::back_inserter(all));
    return all;
}

std::vector<Tie> list_element_ties(const Model& model) {
    std::vector<Tie> all;
    for_each_element_list(model, [&](TieKind kind, const auto&) {
        std::ranges::copy(list_ties(model, kind), std::back_inserter(all));
    });
    return all;
}

std::size_t count_element_ties(const Model& model) {
    std::size_t count = 0;
    for_each_element_list(model, [&](TieKind, const auto& list) { count += list.size(); });
    return count;
}

TieStiffness stiffness_of(const Spring& spring) {
    return {.displacement = find_stiffness(spring), .length = spring.length};
}

TieStiffness stiffness_of(const Bushing& bushing) {
    const auto diagonal = bushing.stiffness.diagonal();
    return {.displacement = diagonal.head<3>().maxCoeff(), .turn = diagonal.tail<3>().maxCoeff()};
}

TieNumbers list_numbers(const Spring& spring) {
    return {{"stiffness", spring.stiffness}, {"damping", spring.damping}, {"free length", spring.length}};
}

TieNumbers list_numbers(const Bushing& bushing) {
    const auto k = [&](int i) { return bushing.stiffness(i, i); };
    return {{"k x", k(0)}, {"k y", k(1)}, {"k z", k(2)}, {"k rx", k(3)}, {"k ry", k(4)}, {"k rz", k(5)}};
}

bool is_strained(const Model& model, const Spring& spring) {
    constexpr double round_off = 1e-12;
    const Vec3 a = find_place(model, spring.ends[0]);
    const Vec3 b = find_place(model, spring.ends[1]);
    const double size = std::max({a.norm(), b.norm(), spring.length});
    const double force = compute_elastic_tension(spring, (b - a).norm());
    return std::abs(force) > round_off * find_stiffness(spring) * size;
}

std::string key_of(const Tie& tie) {
    if (tie.name->starts_with(support_prefix)) return *tie.name;
    return fmt::format("{}.{}", card_of(tie.kind).table, *tie.name);
}

std::size_t number_of(const Model& model, TieKind kind, std::size_t index) {
    assert(kind >= TieKind::joint);
    std::size_t first = 0;
    if (kind > TieKind::joint) first += model.joints.size();
    if (kind > TieKind::gear) first += model.gears.size();
    return first + index;
}

std::size_t count_numbered_ties(const Model& model) {
    return number_of(model, TieKind::sleeve, model.sleeves.size());
}

bool has_joint_friction(const Model& model) {
    return any_coordinate(model, [](const JointCoordinate& one) { return one.friction.acts(); });
}

bool has_stops(const Model& model) {
    return std::ranges::any_of(model.joints, [](const Joint& joint) { return joint.has_stops(); });
}

bool has_breaking_joint(const Model& model) {
    return std::ranges::any_of(model.joints, [](const Joint& joint) { return joint.strength.is_limited(); });
}

bool has_joint_drive(const Model& model) {
    return any_coordinate(model, [](const JointCoordinate& one) {
        return one.motion || !one.drive.is_zero() || (one.stiffness > 0.0 && !one.rest.is_zero());
    });
}

}  // namespace gxrod
