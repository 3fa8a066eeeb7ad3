#pragma once

#include <algorithm>
#include <array>
#include <optional>
#include <string>
#include <type_traits>
#include <variant>
#include <vector>

#include "model/contact_friction.hpp"
#include "model/obstacle_shape.hpp"
#include "model/time/time_function.hpp"
#include "rotation/types.hpp"

// Contact of rods and bodies with obstacles and each other (docs/theory/contact.md).
namespace gxrod {

// The motion of an obstacle from its place at t = 0: a displacement, and a rotation vector about a point.
struct ObstacleMotion {
    TimeVector displacement{Vec3::Zero()};
    TimeVector rotation{Vec3::Zero()};
    Vec3 about = Vec3::Zero();
};

// A rigid obstacle.
struct Obstacle {
    std::string name;
    ObstacleShape shape{};
    double friction = 0.0;              // Coulomb's coefficient, the largest if they differ
    std::optional<double> stiffness{};  // force per length and depth, for a bed that yields
    std::optional<ObstacleMotion> motion{};
    FrictionShape friction_shape{};

    // Returns the shape as one of these; nullptr if it is another one.
    const PlaneShape* plane() const { return std::get_if<PlaneShape>(&shape); }
    const RoundShape* round() const {
        return std::visit(
            [](const auto& own) -> const RoundShape* {
                if constexpr (std::is_base_of_v<RoundShape, std::remove_cvref_t<decltype(own)>>)
                    return &own;
                else
                    return nullptr;
            },
            shape);
    }
    const TriangleMesh* mesh() const {
        const auto* own = std::get_if<MeshShape>(&shape);
        return own == nullptr ? nullptr : own->mesh.get();
    }
    std::vector<Vec3> points() const {
        return std::visit([](const auto& own) { return own.points(); }, shape);
    }
    bool is_hollow() const { return round() != nullptr && round()->is_hollow; }
};

// A shape of a rigid body for contact: all points within a radius of a segment that turns with it. A body can
// have several, which follow each other.
struct ContactBody {
    int body = 0;
    std::array<Vec3, 2> ends{Vec3::Zero(), Vec3::Zero()};  // from the node, body axes; equal for a sphere
    double radius = 0.0;
    double force = 0.0;  // force at which half the skin is left
};

// The contact that a history sums up: of a rod or body with all others and all obstacles, or with one of
// them.
struct ContactWatch {
    int rod = 0;                 // number of the rod; for body b: number of rods + b
    std::optional<int> other{};  // a rod, also the same one; −1 − j: obstacle j
    bool wants_gap = false;      // which needs a search if nothing is near
};

// A rod between two fractions of its length, or an obstacle j: −1 − j.
struct ContactPart {
    int index = 0;
    double from = 0.0, to = 1.0;
};

// An exception for contact between the things of one side and of the other.
struct ContactException {
    std::array<std::vector<ContactPart>, 2> between;
    bool is_off = false;               // they do not touch each other
    std::optional<double> friction{};  // without it, the usual coefficient and shape
    FrictionShape friction_shape{};
    std::optional<double> restitution{};  // coefficient of impacts; of bodies and at obstacles
};

struct Contact {
    std::vector<double> radii;       // radius of each rod; 0: it touches nothing
    std::vector<double> bend_radii;  // for each rod: the tightest bend to expect
    double skin = 0.02;              // gap below which contact acts, relative to the smaller radius
    double dissipation = 1.0;        // dissipation of impacts, 0 … 1
    double damping = 0.0;   // time per length: force × (1 − damping × rate of the gap), never pulling
    double friction = 0.0;  // for rods with each other, and for obstacles without their own
    bool between_rods = false;
    bool within_rods = false;  // whether a rod touches itself
    std::vector<Obstacle> obstacles;
    std::vector<ContactBody> bodies;           // the shapes of bodies that touch
    std::vector<ContactException> exceptions;  // the last one that matches applies
    FrictionShape friction_shape{};            // of `friction`

    bool is_empty() const { return obstacles.empty() && !between_rods && !within_rods; }
    bool has_restitution() const {
        return std::ranges::any_of(exceptions,
                                   [](const ContactException& one) { return one.restitution.has_value(); });
    }
    // Returns the numbers of the bodies that touch, each once.
    std::vector<int> touching_bodies() const {
        std::vector<int> numbers;
        for (const ContactBody& one : bodies) {
            if (numbers.empty() || numbers.back() != one.body) numbers.push_back(one.body);
        }
        return numbers;
    }
};

// Whether any contact has friction.
inline bool rubs(const Contact& contact) {
    const bool has_rods = contact.between_rods || contact.within_rods;
    const auto rubs_there = [](const ContactException& one) { return one.friction.value_or(0.0) > 0.0; };
    return (has_rods && contact.friction > 0.0) || std::ranges::any_of(contact.exceptions, rubs_there) ||
           std::ranges::any_of(contact.obstacles, [](const Obstacle& one) { return one.friction > 0.0; });
}

}  // namespace gxrod
