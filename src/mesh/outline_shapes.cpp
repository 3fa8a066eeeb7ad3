#include "mesh/outline_shapes.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace gxrod {
namespace {

constexpr int sides_of_outline = 24;  // around what is round
constexpr int rings_of_half = 6;      // from the equator of a sphere to its pole
constexpr double sharp_turn = std::numbers::pi / 6.0;

// A circle about the axis of what is round; a point if its radius is 0.
struct Ring {
    double radius, height;
    bool is_drawn = false;
};

int count_corners(const BodyOutline& outline) { return static_cast<int>(outline.points.size()); }

// The surface through rings about an axis that starts at `from`, and four lines along it.
void add_round(const Vec3& from, const Quat& turn, const std::vector<Ring>& rings, BodyOutline& outline) {
    std::vector<int> first;
    for (const Ring& ring : rings) {
        first.push_back(count_corners(outline));
        for (int side = 0; side < (ring.radius > 0.0 ? sides_of_outline : 1); ++side) {
            const double angle = 2.0 * std::numbers::pi * side / sides_of_outline;
            const Vec3 own(ring.radius * std::cos(angle), ring.radius * std::sin(angle), ring.height);
            outline.points.push_back(from + turn * own);
        }
    }
    const auto corner = [&](std::size_t row, int side) {
        return rings[row].radius > 0.0 ? first[row] + side % sides_of_outline : first[row];
    };
    for (std::size_t row = 0; row < rings.size(); ++row) {
        for (int side = 0; side < sides_of_outline; ++side) {
            const int a = corner(row, side), b = corner(row, side + 1);
            if (rings[row].is_drawn) outline.lines.push_back({a, b});
            if (row + 1 == rings.size()) continue;
            const int c = corner(row + 1, side), d = corner(row + 1, side + 1);
            if (a != b) outline.triangles.push_back({a, b, d});
            if (c != d) outline.triangles.push_back({a, d, c});
            if (side % (sides_of_outline / 4) == 0 && rings[row].height != rings[row + 1].height)
                outline.lines.push_back({a, c});
        }
    }
}

// From z to the direction.
Quat turn_to(const Vec3& direction) { return Quat::FromTwoVectors(Vec3::UnitZ(), direction); }

// An edge between two corners, the lower number first, of a triangle.
struct TriangleEdge {
    std::array<int, 2> corners;
    std::size_t triangle;
};

std::vector<TriangleEdge> list_triangle_edges(const TriangleMesh& mesh) {
    std::vector<TriangleEdge> edges;
    for (std::size_t number = 0; number < mesh.triangles.size(); ++number) {
        const std::array<int, 3>& triangle = mesh.triangles[number];
        for (std::size_t i = 0; i < 3; ++i) {
            const auto [low, high] = std::minmax(triangle[i], triangle[(i + 1) % 3]);
            edges.push_back({{low, high}, number});
        }
    }
    std::ranges::stable_sort(edges, {}, &TriangleEdge::corners);
    return edges;
}

Vec3 normal_of(const TriangleMesh& mesh, std::size_t number) {
    const std::array<int, 3>& triangle = mesh.triangles[number];
    const auto corner = [&](std::size_t i) { return mesh.positions[static_cast<std::size_t>(triangle[i])]; };
    return (corner(1) - corner(0)).cross(corner(2) - corner(0)).stableNormalized();
}

std::vector<std::array<int, 2>> find_sharp_edges(const TriangleMesh& mesh) {
    const std::vector<TriangleEdge> edges = list_triangle_edges(mesh);
    std::vector<std::array<int, 2>> sharp;
    for (std::size_t i = 0, next = 0; i < edges.size(); i = next) {
        for (next = i; next < edges.size() && edges[next].corners == edges[i].corners;) ++next;
        const bool is_flat =
            next == i + 2 && normal_of(mesh, edges[i].triangle).dot(normal_of(mesh, edges[i + 1].triangle)) >
                                 std::cos(sharp_turn);
        if (!is_flat) sharp.push_back(edges[i].corners);
    }
    return sharp;
}

}  // namespace

void add_box(const Vec3& half_sizes, const ShapePlace& place, BodyOutline& outline) {
    const int first = count_corners(outline);
    // Corner number: bit i says on which side along axis i it is.
    for (int corner = 0; corner < 8; ++corner) {
        Vec3 sides = half_sizes;
        for (int i = 0; i < 3; ++i) sides[i] *= (corner >> i & 1) != 0 ? 1.0 : -1.0;
        outline.points.push_back(place.at + place.turn * sides);
        for (int i = 0; i < 3; ++i) {
            if ((corner >> i & 1) == 0) outline.lines.push_back({first + corner, first + (corner | 1 << i)});
        }
    }
    for (int i = 0; i < 3; ++i) {
        const int a = 1 << (i + 1) % 3, b = 1 << (i + 2) % 3, far = first + (1 << i);
        outline.triangles.push_back({far, far + a, far + a + b});
        outline.triangles.push_back({far, far + a + b, far + b});
        outline.triangles.push_back({first, first + a + b, first + a});
        outline.triangles.push_back({first, first + b, first + a + b});
    }
}

void add_cylinder(const Vec3& from, const Vec3& to, double radius, BodyOutline& outline) {
    const double length = (to - from).norm();
    const std::vector<Ring> rings{{0.0, 0.0}, {radius, 0.0, true}, {radius, length, true}, {0.0, length}};
    add_round(from, turn_to(to - from), rings, outline);
}

void add_capsule(const Vec3& from, const Vec3& to, double radius, BodyOutline& outline) {
    const double length = (to - from).norm();
    std::vector<Ring> rings;
    for (const bool is_upper : {false, true}) {
        for (int i = 0; i <= rings_of_half; ++i) {
            const int row = is_upper ? i : rings_of_half - i;
            if (is_upper && row == 0 && length == 0.0) continue;  // a sphere has one equator
            const double angle = 0.5 * std::numbers::pi * row / rings_of_half;
            const double height = radius * std::sin(angle);
            rings.push_back({row == rings_of_half ? 0.0 : radius * std::cos(angle),
                             is_upper ? length + height : -height,
                             row == 0});
        }
    }
    add_round(from, length > 0.0 ? turn_to(to - from) : Quat::Identity(), rings, outline);
}

void add_lines(const std::vector<Vec3>& points, BodyOutline& outline) {
    for (std::size_t i = 0; i < points.size(); ++i) {
        if (i > 0) outline.lines.push_back({count_corners(outline) - 1, count_corners(outline)});
        outline.points.push_back(points[i]);
    }
}

void add_triangles(const TriangleMesh& mesh, const ShapePlace& place, BodyOutline& outline) {
    const int first = count_corners(outline);
    for (const Vec3& position : mesh.positions) outline.points.push_back(place.at + place.turn * position);
    for (const std::array<int, 3>& corners : mesh.triangles)
        outline.triangles.push_back({first + corners[0], first + corners[1], first + corners[2]});
    for (const std::array<int, 2>& edge : find_sharp_edges(mesh))
        outline.lines.push_back({first + edge[0], first + edge[1]});
}

}  // namespace gxrod
