#include "contact/meshes/triangle_distance.hpp"

#include <algorithm>
#include <cmath>

namespace gxrod {

Triangle make_triangle(const Vec3& a, const Vec3& b, const Vec3& c) {
    Triangle triangle{.corners = {a, b, c}};
    triangle.normal = (b - a).cross(c - a).stableNormalized();
    for (std::size_t i = 0; i < 3; ++i) {
        const Vec3 edge = triangle.corners[(i + 1) % 3] - triangle.corners[i];
        triangle.lengths[i] = edge.norm();
        triangle.along[i] = edge / triangle.lengths[i];
        triangle.out[i] = triangle.along[i].cross(triangle.normal);
    }
    return triangle;
}

// Beyond an edge the closest point is on it or on one of the others; each is asked, since triangles can be
// thin.
ClosestOnTriangle find_on_triangle(const Triangle& triangle, const Vec3& point) {
    ClosestOnTriangle closest;
    const Vec3 offset = point - triangle.corners[0];
    const double height = offset.dot(triangle.normal);
    bool is_inside = true;
    for (std::size_t i = 0; i < 3; ++i)
        is_inside = is_inside && (point - triangle.corners[i]).dot(triangle.out[i]) <= 0.0;
    if (is_inside) {
        closest.position = point - height * triangle.normal;
        closest.distance = std::abs(height);
        return closest;
    }
    closest.distance = std::numeric_limits<double>::infinity();
    for (std::size_t i = 0; i < 3; ++i) {
        const double along = (point - triangle.corners[i]).dot(triangle.along[i]);
        const double kept = std::clamp(along, 0.0, triangle.lengths[i]);
        const Vec3 position = triangle.corners[i] + kept * triangle.along[i];
        const double distance = (point - position).norm();
        if (distance >= closest.distance) continue;
        const bool is_corner = kept != along;
        closest = {position, distance, is_corner, is_corner ? -1 : static_cast<int>(i)};
    }
    return closest;
}

bool crosses(const Triangle& triangle, const Vec3& from, const Vec3& to) {
    const double start = (from - triangle.corners[0]).dot(triangle.normal);
    const double end = (to - triangle.corners[0]).dot(triangle.normal);
    if (start * end > 0.0 || start == end) return false;
    const Vec3 at = from + start / (start - end) * (to - from);
    for (std::size_t i = 0; i < 3; ++i)
        if ((at - triangle.corners[i]).dot(triangle.out[i]) > 0.0) return false;
    return true;
}

}  // namespace gxrod
