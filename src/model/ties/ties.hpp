#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <string>
#include <vector>

#include "model/anchor.hpp"
#include "model/joint.hpp"
#include "model/model.hpp"

// Lists the ties between two points: springs, bushings, joints, gears and sleeves. Code that concerns all of
// them asks this list, so that it forgets no kind.
namespace gxrod {

enum class TieKind { spring, bushing, joint, gear, sleeve };
inline constexpr std::size_t tie_kind_count = 5;

struct Tie {
    TieKind kind;
    std::size_t index;  // in the model's list of its kind
    const std::string* name;
    // A and B. A sleeve's A is the first node of its rod; a gear's ends are those that its joints move.
    std::array<Anchor, 2> ends;

    bool has_ground() const { return ends[0].is_ground() || ends[1].is_ground(); }
};

// Lists all ties, kind by kind; the model must outlive them.
std::vector<Tie> list_ties(const Model& model);
std::vector<Tie> list_ties(const Model& model, TieKind kind);

// Names a tie as its table of the deck: "spring.strut"; a sleeve is a joint there.
std::string key_of(const Tie& tie);

// Springs and bushings are elements. Lists them, in the order in which blocks and groups of scales count
// them.
std::vector<Tie> list_element_ties(const Model& model);
std::size_t count_element_ties(const Model& model);
// Returns the largest stiffness of such a tie against displacements and against turns.
struct TieStiffness {
    double displacement = 0.0;
    double turn = 0.0;
};
TieStiffness stiffness_of(const Model& model, const Tie& tie);

// Joints, gears and sleeves are numbered together, in this order: states, their equations and what snapshots
// have of them. Returns the number of one, by its index in the list of its kind.
std::size_t number_of(const Model& model, TieKind kind, std::size_t index);
// Returns how many numbers joints, gears and sleeves have.
std::size_t count_numbered_ties(const Model& model);

// Calls visit(anchor) for each point that a tie has on a node or on the ground, of a model that is const or
// not.
template <class AnyModel, class Visit>
void for_each_anchor(AnyModel& model, Visit&& visit) {
    const auto visit_ends = [&](auto& ties) {
        for (auto& tie : ties) std::ranges::for_each(tie.ends, visit);
    };
    visit_ends(model.springs);
    visit_ends(model.bushings);
    for (auto& joint : model.joints) {
        visit(joint.a.anchor);
        visit(joint.b.anchor);
    }
    for (auto& sleeve : model.sleeves) visit(sleeve.point);
}

// Calls visit(number, name, turn, slide) for the coordinates of each joint and each sleeve, of a model that
// is const or not. On the turn that is visited with a sleeve nothing acts.
template <class AnyModel, class Visit>
void for_each_coordinates(AnyModel& model, Visit&& visit) {
    for (std::size_t i = 0; i < model.joints.size(); ++i) {
        auto& joint = model.joints[i];
        visit(number_of(model, TieKind::joint, i), joint.name, joint.turn, joint.slide);
    }
    for (std::size_t i = 0; i < model.sleeves.size(); ++i) {
        auto& sleeve = model.sleeves[i];
        JointCoordinate no_turn;
        visit(number_of(model, TieKind::sleeve, i), sleeve.name, no_turn, sleeve.slide);
    }
}

// Returns whether the condition applies to the turn or the slide of a joint or sleeve.
template <class Condition>
bool any_coordinate(const Model& model, Condition&& condition) {
    const auto of_joint = [&](const Joint& joint) { return condition(joint.turn) || condition(joint.slide); };
    const auto of_sleeve = [&](const Sleeve& sleeve) { return condition(sleeve.slide); };
    return std::ranges::any_of(model.joints, of_joint) || std::ranges::any_of(model.sleeves, of_sleeve);
}

// Returns whether friction acts on a coordinate of a joint or sleeve.
bool has_joint_friction(const Model& model);
// Returns whether a motor, a drive or the rest of a spring can move a coordinate of a joint or sleeve.
bool has_joint_drive(const Model& model);

}  // namespace gxrod
