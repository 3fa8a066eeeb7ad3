#pragma once

#include <array>

#include "rotation/types.hpp"

namespace gxrod {

// A flat triangle, with the axes of its edges; edge i goes from corner i to the next one.
struct Triangle {
    std::array<Vec3, 3> corners;
    Vec3 normal = Vec3::Zero();   // unit vector, counterclockwise about it
    std::array<Vec3, 3> along{};  // the edges' directions, of length 1
    std::array<Vec3, 3> out{};    // away from the triangle, in its plane, of length 1
    std::array<double, 3> lengths{};
};
// Makes a triangle from three points that are not on a line.
Triangle make_triangle(const Vec3& a, const Vec3& b, const Vec3& c);

// The point of a triangle that is closest to another point.
struct ClosestOnTriangle {
    Vec3 position = Vec3::Zero();
    double distance = 0.0;
    bool is_corner = false;
    int edge = -1;  // the edge that it lies on, without its ends
};
ClosestOnTriangle find_on_triangle(const Triangle& triangle, const Vec3& point);

// Whether the straight line between two points meets the triangle.
bool crosses(const Triangle& triangle, const Vec3& from, const Vec3& to);

}  // namespace gxrod
