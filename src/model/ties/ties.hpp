#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <string>
#include <string_view>
#include <tuple>
#include <utility>
#include <vector>

#include "model/anchor.hpp"
#include "model/joint.hpp"
#include "model/model.hpp"

// Lists the ties between two points: springs, bushings, joints, gears and sleeves. Code that concerns all of
// them asks this list, so that it forgets no kind.
namespace gxrod {

// The kinds that are elements come first; `joint` is the first kind that has equations instead.
enum class TieKind { spring, bushing, joint, gear, sleeve };

struct TieCard {
    std::string_view table;  // of the deck
    const char* names;       // in the plural
};

inline constexpr std::array tie_cards{TieCard{"spring", "springs"},
                                      TieCard{"bushing", "bushings"},
                                      TieCard{"joint", "joints"},
                                      TieCard{"gear", "gears"},
                                      TieCard{"joint", "sleeves"}};
inline constexpr std::size_t tie_kind_count = tie_cards.size();

constexpr const TieCard& card_of(TieKind kind) { return tie_cards[static_cast<std::size_t>(kind)]; }

// Returns the model's lists of ties, in the order of the kinds, of a model that is const or not.
template <class AnyModel>
auto tie_lists_of(AnyModel& model) {
    return std::tie(model.springs, model.bushings, model.joints, model.gears, model.sleeves);
}

constexpr bool is_element(TieKind kind) { return kind < TieKind::joint; }

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

// Calls visit(kind, list) for each of the model's lists of ties, of a model that is const or not.
template <class AnyModel, class Visit>
void for_each_tie_list(AnyModel& model, Visit&& visit) {
    const auto visit_all = [&](auto&... lists) {
        std::size_t kind = 0;
        (visit(static_cast<TieKind>(kind++), lists), ...);
    };
    std::apply(visit_all, tie_lists_of(model));
}

// Does so for the ties that are elements, in the order in which blocks and groups of scales count them.
template <class AnyModel, class Visit>
void for_each_element_list(AnyModel& model, Visit&& visit) {
    const auto visit_elements = [&]<std::size_t... kind>(std::index_sequence<kind...>) {
        (visit(static_cast<TieKind>(kind), std::get<kind>(tie_lists_of(model))), ...);
    };
    visit_elements(std::make_index_sequence<static_cast<std::size_t>(TieKind::joint)>());
}

// Calls visit(kind, tie) for each tie that is an element, in the same order.
template <class AnyModel, class Visit>
void for_each_element_tie(AnyModel& model, Visit&& visit) {
    for_each_element_list(model, [&](TieKind kind, auto& list) {
        for (auto& tie : list) visit(kind, tie);
    });
}

// Returns whether the condition applies to a tie that is an element.
template <class Condition>
bool any_element_tie(const Model& model, Condition&& condition) {
    bool any = false;
    for_each_element_tie(model, [&](TieKind, const auto& tie) { any = any || condition(tie); });
    return any;
}

// Lists the ties that are elements, in the same order.
std::vector<Tie> list_element_ties(const Model& model);
std::size_t count_element_ties(const Model& model);

// The largest stiffness of such a tie against displacements and against turns, and a length of its own, as
// good as places of nodes are.
struct TieStiffness {
    double displacement = 0.0;
    double turn = 0.0;
    double length = 0.0;
};
TieStiffness stiffness_of(const Spring& spring);
TieStiffness stiffness_of(const Bushing& bushing);

// Lists the numbers of a tie, each with its heading in tables for people.
using TieNumbers = std::vector<std::pair<const char*, double>>;
TieNumbers list_numbers(const Spring& spring);
TieNumbers list_numbers(const Bushing& bushing);

// Returns whether such a tie pulls or pushes at t = 0.
bool is_strained(const Model& model, const Spring& spring);
inline bool is_strained(const Model&, const Bushing&) { return false; }

// Joints, gears and sleeves are numbered together, in this order: states, their equations and what snapshots
// have of them. Returns the number of one, by its index in the list of its kind.
std::size_t number_of(const Model& model, TieKind kind, std::size_t index);
// Returns how many numbers joints, gears and sleeves have.
std::size_t count_numbered_ties(const Model& model);

// Calls visit(anchor) for each point that a tie has on a node or on the ground, of a model that is const or
// not.
template <class AnyModel, class Visit>
void for_each_anchor(AnyModel& model, Visit&& visit) {
    for_each_element_tie(model, [&](TieKind, auto& tie) { std::ranges::for_each(tie.ends, visit); });
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
bool has_breaking_joint(const Model& model);
// Returns whether a joint has equations that hold on one side only.
bool has_stops(const Model& model);

}  // namespace gxrod
