#pragma once

#include <optional>

#include "contact/meshes/triangle_distance.hpp"
#include "contact/second_order.hpp"

// The nearness of a place to triangles, a number that sums over them (docs/theory/contact.md, (C8) to (C10)).
namespace gxrod {

using Nearness = SecondOrder<3>;  // by the coordinates of the place

// Computes the nearness of a triangle to a point whose distance from it is above `radius`: ∫ Φ dA, zero
// beyond radius + skin. An infinite plane has W(u) = (1 − u/w)³ w/u, with u = d² − radius² and w its value at
// radius + skin; parts of a plane sum up to it but for round-off.
Nearness compute_nearness(const Triangle& triangle, const Vec3& point, double radius, double skin);

// Finds the gap of an equally near plane, with its derivatives; nullopt if nothing is near.
std::optional<Nearness> find_gap(const Nearness& nearness, double radius, double skin);

}  // namespace gxrod
