#pragma once

#include <array>
#include <cstddef>
#include <memory>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include "rotation/types.hpp"

// The shapes of obstacles, at t = 0. Each has its word in decks, and says where it is by `points`, whether
// its distance is never below that of a tangent plane by `is_convex`, and how it turns about the origin by
// `turn`.
namespace gxrod {

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

// A half space, on whose other side rods are.
struct PlaneShape {
    static constexpr const char* word = "plane";
    Vec3 point = Vec3::Zero();
    Vec3 normal = Vec3::UnitZ();  // towards the rods, of length 1

    std::vector<Vec3> points() const { return {point}; }
    bool is_convex() const { return true; }
    void turn(const Quat& rotation) {
        point = rotation * point;
        normal = rotation * normal;
    }
};

// All points within a radius of a point or a line; rods are inside of a hollow one.
struct RoundShape {
    double radius = 0.0;
    bool is_hollow = false;
};

struct SphereShape : RoundShape {
    static constexpr const char* word = "sphere";
    Vec3 centre = Vec3::Zero();

    std::vector<Vec3> points() const { return {centre}; }
    bool is_convex() const { return !is_hollow; }
    void turn(const Quat& rotation) { centre = rotation * centre; }
};

// Rounded ends close it; a hollow one has no ends.
struct CylinderShape : RoundShape {
    static constexpr const char* word = "cylinder";
    Vec3 from = Vec3::Zero(), to = Vec3::Zero();

    std::vector<Vec3> points() const { return {from, to}; }
    bool is_convex() const { return !is_hollow; }
    void turn(const Quat& rotation) {
        from = rotation * from;
        to = rotation * to;
    }
};

// Its line is a spline; the ends of a hollow one continue straight.
struct TubeShape : RoundShape {
    static constexpr const char* word = "tube";
    std::vector<Vec3> line;
    std::vector<Vec3> tangents;  // by arc length, at each point of the line

    const std::vector<Vec3>& points() const { return line; }
    bool is_convex() const { return false; }
    void turn(const Quat& rotation) {
        for (Vec3& point : line) point = rotation * point;
        for (Vec3& tangent : tangents) tangent = rotation * tangent;
    }
};

struct MeshShape {
    static constexpr const char* word = "mesh";
    std::shared_ptr<const TriangleMesh> mesh;

    const std::vector<Vec3>& points() const { return mesh->positions; }
    bool is_convex() const { return true; }  // each triangle is
    void turn(const Quat& rotation) {
        auto turned = std::make_shared<TriangleMesh>(*mesh);
        for (Vec3& position : turned->positions) position = rotation * position;
        mesh = std::move(turned);
    }
};

using ObstacleShape = std::variant<PlaneShape, SphereShape, CylinderShape, TubeShape, MeshShape>;

}  // namespace gxrod
