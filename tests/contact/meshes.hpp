#pragma once

#include <cmath>
#include <memory>
#include <utility>

#include "model/contact.hpp"
#include "tools/random_values.hpp"

// Meshes to touch.
namespace gxrod {

inline int add_position(const Vec3& position, TriangleMesh& mesh) {
    mesh.positions.push_back(position);
    return static_cast<int>(mesh.positions.size()) - 1;
}

inline void number(TriangleMesh& mesh) {
    for (std::size_t i = 0; i < mesh.triangles.size(); ++i) mesh.numbers.push_back(static_cast<int>(i) + 1);
    mesh.feature_angle = 0.35;
}

// Points in rows, position(i, j), with two triangles between four of them.
template <class Position>
TriangleMesh make_grid(int rows, int columns, const Position& position) {
    TriangleMesh mesh;
    for (int i = 0; i <= rows; ++i)
        for (int j = 0; j <= columns; ++j) add_position(position(i, j), mesh);
    for (int i = 0; i < rows; ++i) {
        for (int j = 0; j < columns; ++j) {
            const int a = i * (columns + 1) + j, b = a + 1, c = a + columns + 1, d = c + 1;
            mesh.triangles.push_back({a, c, d});
            mesh.triangles.push_back({a, d, b});
        }
    }
    number(mesh);
    return mesh;
}

// The square |x|, |y| < half a side at z = 0, in so many pieces a side.
inline TriangleMesh make_floor(double half, int pieces) {
    return make_grid(pieces, pieces, [&](int i, int j) {
        return Vec3(half * (2.0 * i / pieces - 1.0), half * (2.0 * j / pieces - 1.0), 0.0);
    });
}

// About z; the first corner is on the x axis.
inline TriangleMesh make_cylinder(double radius, double from, double to, int facets, int pieces) {
    TriangleMesh mesh;
    for (int i = 0; i <= pieces; ++i) {
        for (int j = 0; j < facets; ++j) {
            const double angle = 2.0 * M_PI * j / facets;
            add_position(
                {radius * std::cos(angle), radius * std::sin(angle), from + (to - from) * i / pieces}, mesh);
        }
    }
    for (int i = 0; i < pieces; ++i) {
        for (int j = 0; j < facets; ++j) {
            const int next = (j + 1) % facets;
            const int a = i * facets + j, b = i * facets + next, c = a + facets, d = b + facets;
            mesh.triangles.push_back({a, b, d});
            mesh.triangles.push_back({a, d, c});
        }
    }
    number(mesh);
    return mesh;
}

// z = slope |y| along x, whose bottom is a line of edges.
inline TriangleMesh make_groove(double slope, double half, int pieces) {
    return make_grid(pieces, 2, [&](int i, int j) {
        return Vec3(half * (2.0 * i / pieces - 1.0), half * (j - 1), slope * half * std::abs(j - 1));
    });
}

inline TriangleMesh make_cube(double side) {
    TriangleMesh mesh;
    for (int i = 0; i < 8; ++i)
        add_position(0.5 * side * Vec3(i & 1 ? 1 : -1, i & 2 ? 1 : -1, i & 4 ? 1 : -1), mesh);
    for (const auto& [a, b, c, d] : {std::array{0, 2, 3, 1},
                                     std::array{4, 5, 7, 6},
                                     std::array{0, 1, 5, 4},
                                     std::array{2, 6, 7, 3},
                                     std::array{0, 4, 6, 2},
                                     std::array{1, 3, 7, 5}}) {
        mesh.triangles.push_back({a, b, c});
        mesh.triangles.push_back({a, c, d});
    }
    number(mesh);
    return mesh;
}

// Triangles anywhere, within 2 of the origin.
inline TriangleMesh make_soup(int count, unsigned seed) {
    tools::RandomValues random(seed);
    TriangleMesh mesh;
    for (int i = 0; i < count; ++i) {
        const Vec3 at = random.vector(1.5);
        std::array<int, 3> corners{};
        for (int& corner : corners) corner = add_position(at + random.vector(0.5), mesh);
        mesh.triangles.push_back(corners);
    }
    number(mesh);
    return mesh;
}

inline Obstacle make_obstacle(TriangleMesh mesh) {
    Obstacle obstacle;
    obstacle.name = "mesh";
    obstacle.shape = MeshShape{std::make_shared<TriangleMesh>(std::move(mesh))};
    return obstacle;
}

}  // namespace gxrod
