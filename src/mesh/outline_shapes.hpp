#pragma once

#include "model/bodies/body_outline.hpp"
#include "model/obstacle_shape.hpp"

// Shapes as triangles and lines of an outline: positions from a body's node, body axes.
namespace gxrod {

// How a shape is turned, and then moved, within a body.
struct ShapePlace {
    Vec3 at = Vec3::Zero();
    Quat turn = Quat::Identity();
};

// Adds a box about `place`.
void add_box(const Vec3& half_sizes, const ShapePlace& place, BodyOutline& outline);
// Adds a cylinder with flat ends that are apart.
void add_cylinder(const Vec3& from, const Vec3& to, double radius, BodyOutline& outline);
// Adds all points within a radius of a segment; a sphere if its ends are one point.
void add_capsule(const Vec3& from, const Vec3& to, double radius, BodyOutline& outline);
// Adds a polyline.
void add_lines(const std::vector<Vec3>& points, BodyOutline& outline);
// Adds triangles; edges that are open or turn by more than 30° become lines.
void add_triangles(const TriangleMesh& mesh, const ShapePlace& place, BodyOutline& outline);

}  // namespace gxrod
