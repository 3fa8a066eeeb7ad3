#pragma once

#include <array>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "model/time/time_function.hpp"
#include "rotation/types.hpp"

// What rods and bodies touch: obstacles, and each other (docs/theory/contact.md).
namespace gxrod {

// How an obstacle moves from where it is at t = 0: by a displacement, and turned about a point by a rotation
// vector.
struct ObstacleMotion {
    TimeVector displacement{Vec3::Zero()};
    TimeVector rotation{Vec3::Zero()};
    Vec3 about = Vec3::Zero();
};

// The triangles of a file, whichever side of them rods are on. What lies upon each other is merged.
struct TriangleMesh {
    std::string file;  // as the deck names it
    std::vector<Vec3> positions;
    std::vector<std::array<int, 3>> triangles;
    std::vector<int> numbers;    // of the triangles, in the file, from 1
    double feature_angle = 0.0;  // edges that turn by more are sharp
    std::size_t left_out = 0;    // triangles without area
    std::size_t repeated = 0;    // left out too, for another has the same corners
    std::size_t open_edges = 0;  // with one triangle
};

// A body of a simple form, which does not deform. Where it is hollow rods are inside.
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
    Vec3 normal = Vec3::UnitZ();  // of a plane, towards the rods, of length 1
    std::vector<Vec3> line;       // of a plane a point of it
    std::vector<Vec3> tangents;   // of a tube, by arc length, at each point of the line
    double radius = 0.0;
    std::shared_ptr<const TriangleMesh> mesh{};
    double friction = 0.0;              // Coulomb's coefficient
    std::optional<double> stiffness{};  // force per length and depth, of a bed that yields
    std::optional<ObstacleMotion> motion{};
};

// The shape by which a rigid body touches: all within a radius of a segment that turns with it.
struct ContactBody {
    int body = 0;
    std::array<Vec3, 2> ends{Vec3::Zero(), Vec3::Zero()};  // from the node, body axes; equal: a sphere
    double radius = 0.0;
    double force = 0.0;  // that leaves half the skin
};

// What a history adds up: the contact of a rod or body with all others and all obstacles, or with one of
// them.
struct ContactWatch {
    int rod = 0;                 // a body b is number of rods + b
    std::optional<int> other{};  // a rod, itself too; −1 − j: obstacle j
    bool wants_gap = false;      // which takes a search where nothing is near
};

// A rod between two fractions of its length, or the obstacle j: −1 − j.
struct ContactPart {
    int index = 0;
    double from = 0.0, to = 1.0;
};

// What is different where something of one side touches something of the other.
struct ContactException {
    std::array<std::vector<ContactPart>, 2> between;
    bool is_off = false;               // they pass through each other
    std::optional<double> friction{};  // without it, what it is otherwise
};

struct Contact {
    std::vector<double> radii;       // of each rod; 0: it touches nothing
    std::vector<double> bend_radii;  // of each rod: the tightest bend to expect
    double skin = 0.02;              // below this gap contact acts, times the smaller radius
    double dissipation = 1.0;        // of impacts, 0 … 1
    double damping = 0.0;   // time per length: force × (1 − damping × rate of the gap), never pulling
    double friction = 0.0;  // of rods with each other, and of obstacles that have none of their own
    bool between_rods = false;
    bool within_rods = false;  // a rod touches itself
    std::vector<Obstacle> obstacles;
    std::vector<ContactBody> bodies;           // that touch
    std::vector<ContactException> exceptions;  // the last one that fits counts

    bool is_empty() const { return obstacles.empty() && !between_rods && !within_rods; }
};

}  // namespace gxrod
