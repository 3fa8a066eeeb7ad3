#pragma once

#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "model/model.hpp"
#include "model/ties/ties.hpp"

namespace gxrod {

// The things that a history can be of. Each has its index in the model's list of such things.

// A point of a rod; where elements meet, in the first of them.
struct WatchedPoint {
    RodPlace place;
    int node = -1;  // -1: between nodes
};

struct WatchedBody {
    int index = 0;
    int node = 0;
    std::optional<ContactWatch> contact = {};  // with quantities of contact
};

// A spring, a bushing, a joint, a gear or a sleeve.
struct WatchedTie {
    TieKind kind;
    int index = 0;
};

struct WatchedTendon {
    int index = 0;
};

struct WatchedObstacle {
    int index = 0;
};

// A rod as a whole, and what touches it.
struct WatchedContacts {
    ContactWatch contact;
};

using Watched =
    std::variant<WatchedPoint, WatchedBody, WatchedTendon, WatchedObstacle, WatchedContacts, WatchedTie>;

// The node of a point or a body; -1 between nodes and where there is none.
inline int node_of(const Watched& target) {
    if (const auto* point = std::get_if<WatchedPoint>(&target)) return point->node;
    if (const auto* body = std::get_if<WatchedBody>(&target)) return body->node;
    return -1;
}

// Whether it is a tie of this kind.
inline bool is_tie(const Watched& target, TieKind kind) {
    const auto* tie = std::get_if<WatchedTie>(&target);
    return tie != nullptr && tie->kind == kind;
}

// The contacts that are recorded for it; nullptr without any.
inline const ContactWatch* contact_of(const Watched& target) {
    if (const auto* contacts = std::get_if<WatchedContacts>(&target)) return &contacts->contact;
    const auto* body = std::get_if<WatchedBody>(&target);
    return body != nullptr && body->contact ? &*body->contact : nullptr;
}

// Names a thing and the quantities to record of it at every accepted step.
struct HistoryRequest {
    std::string name;
    std::string at;  // as the deck has it
    Watched target = {};
    std::vector<std::string> quantities = {};  // their words (watch/quantities.hpp)
    // Where the deck says relative_to: components are in the axes of this node, positions from its place.
    std::string relative_to = {};  // as the deck has it
    int relative_node = -1;
    Quat relative_axes = Quat::Identity();  // of section or body there at t = 0
    // Where moments of reactions are about a point, fixed in space, and not about the support's.
    std::optional<Vec3> about = {};
    // The direction with which a rod's axis makes `no_load_angle`: global at t = 0, carried along where the
    // history is relative to a point. nullopt: that of the axis at t = 0.
    std::optional<Vec3> no_load = {};
    std::string with = {};  // what the contacts are with, as the deck has it
    // Where in the section stresses are recorded, (y, z) in its axes; nullopt: where they are worst.
    std::optional<Eigen::Vector2d> section_point = {};
    std::string criterion = {};  // of failure, by its word; "": von Mises
};

}  // namespace gxrod
