#pragma once

#include <optional>

#include "contact/meshes/triangle_distance.hpp"
#include "contact/second_order.hpp"

// How near a place is to triangles, in a number that sums over them (docs/theory/contact.md, (C8) to (C10)).
namespace gxrod {

using Nearness = SecondOrder<3>;  // by the coordinates of the place

// Of a triangle to a point whose distance from it is above `radius`: ∫ Φ dA, zero beyond radius + skin. A
// plane without ends has W(u) = (1 − u/w)³ w/u, with u = d² − radius² and w what that is at radius + skin;
// parts of a plane sum up to it but for round-off.
Nearness compute_nearness(const Triangle& triangle, const Vec3& point, double radius, double skin);

// The gap of a plane that is as near, with its derivatives; nullopt where nothing is near.
std::optional<Nearness> find_gap(const Nearness& nearness, double radius, double skin);

}  // namespace gxrod
