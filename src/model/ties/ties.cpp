#include "model/ties/ties.hpp"

#include <cassert>

namespace gxrod {

std::vector<Tie> list_ties(const Model& model, TieKind kind) {
    std::vector<Tie> ties;
    const auto add = [&](const auto& things, const auto& ends_of) {
        for (std::size_t i = 0; i < things.size(); ++i)
            ties.push_back({kind, i, &things[i].name, ends_of(things[i])});
    };
    switch (kind) {
        case TieKind::spring:
            add(model.springs, [](const Spring& spring) { return spring.ends; });
            break;
        case TieKind::bushing:
            add(model.bushings, [](const Bushing& bushing) { return bushing.ends; });
            break;
        case TieKind::joint:
            add(model.joints, [](const Joint& joint) { return std::array{joint.a.anchor, joint.b.anchor}; });
            break;
        case TieKind::gear:
            add(model.gears, [&](const Gear& gear) {
                const auto moved = [&](const GearSide& side) {
                    return model.joints[static_cast<std::size_t>(side.joint)].moving_anchor();
                };
                return std::array{moved(gear.sides[0]), moved(gear.sides[1])};
            });
            break;
        case TieKind::sleeve:
            add(model.sleeves, [&](const Sleeve& sleeve) {
                const Rod& rod = model.rods[static_cast<std::size_t>(sleeve.rod)];
                return std::array{Anchor{.node = rod.nodes.front()}, sleeve.point};
            });
            break;
    }
    return ties;
}

std::vector<Tie> list_ties(const Model& model) {
    std::vector<Tie> all;
    for (std::size_t kind = 0; kind < tie_kind_count; ++kind) {
        const std::vector<Tie> ties = list_ties(model, static_cast<TieKind>(kind));
        all.insert(all.end(), ties.begin(), ties.end());
    }
    return all;
}

std::vector<Tie> list_element_ties(const Model& model) {
    std::vector<Tie> ties = list_ties(model, TieKind::spring);
    const std::vector<Tie> bushings = list_ties(model, TieKind::bushing);
    ties.insert(ties.end(), bushings.begin(), bushings.end());
    return ties;
}

std::size_t count_element_ties(const Model& model) { return model.springs.size() + model.bushings.size(); }

TieStiffness stiffness_of(const Model& model, const Tie& tie) {
    if (tie.kind == TieKind::spring) return {.displacement = find_stiffness(model.springs[tie.index])};
    assert(tie.kind == TieKind::bushing);
    const auto diagonal = model.bushings[tie.index].stiffness.diagonal();
    return {diagonal.head<3>().maxCoeff(), diagonal.tail<3>().maxCoeff()};
}

std::string key_of(const Tie& tie) {
    constexpr std::array<const char*, tie_kind_count> tables{
        "spring.", "bushing.", "joint.", "gear.", "joint."};
    return tables[static_cast<std::size_t>(tie.kind)] + *tie.name;
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

bool has_joint_drive(const Model& model) {
    return any_coordinate(model, [](const JointCoordinate& one) {
        return one.motion || !one.drive.is_zero() || (one.stiffness > 0.0 && !one.rest.is_zero());
    });
}

}  // namespace gxrod
