#pragma once

#include <array>
#include <memory>
#include <optional>
#include <string>
#include <vector>

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

// The triangles of a file; rods may be on either side. Coincident corners and triangles are merged.
struct TriangleMesh {
    std::string file;  // name in the deck
    std::vector<Vec3> positions;
    std::vector<std::array<int, 3>> triangles;
    std::vector<int> numbers;    // numbers of the triangles in the file, from 1
    double feature_angle = 0.0;  // edges with a larger turn are sharp
    std::size_t left_out = 0;    // triangles without area
    std::size_t repeated = 0;    // left out too, since another triangle has the same corners
    std::size_t open_edges = 0;  // edges with one triangle
};

// A rigid obstacle of a simple form. Rods are inside of a hollow one.
struct Obstacle {
    enum class Shape {
        plane,     // a half space
        sphere,    // about the first point of the line
        cylinder,  // about the line from its first point to its last one; hollow, without ends
        tube,      // about the line through all points, a spline; hollow, its ends continue straight
        mesh       // triangles
    };
    std::string name;
    Shape shape = Shape::plane;
    bool is_hollow = false;
    Vec3 normal = Vec3::UnitZ();  // for a plane, towards the rods, of length 1
    std::vector<Vec3> line;       // for a plane one of its points
    std::vector<Vec3> tangents;   // for a tube, by arc length, at each point of the line
    double radius = 0.0;
    std::shared_ptr<const TriangleMesh> mesh{};
    double friction = 0.0;              // Coulomb's coefficient
    std::optional<double> stiffness{};  // force per length and depth, for a bed that yields
    std::optional<ObstacleMotion> motion{};
};

// The shape of a rigid body for contact: all points within a radius of a segment that turns with it.
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
    std::optional<double> friction{};  // without it, the usual coefficient
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
    std::vector<ContactBody> bodies;           // bodies that touch
    std::vector<ContactException> exceptions;  // the last one that matches applies

    bool is_empty() const { return obstacles.empty() && !between_rods && !within_rods; }
};

}  // namespace gxrod
