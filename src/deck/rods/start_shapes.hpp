#pragma once

#include <optional>
#include <vector>

#include "model/displaced_start.hpp"
#include "watch/members.hpp"

// Displaces the start of a structure that is not perfect.
namespace gxrod {

// Returns the unit vector of the part of a direction across a unit vector; nullopt if they are parallel.
std::optional<Vec3> project_across(const Vec3& direction, const Vec3& axis);

// Adds a shape, displacements and spins of all nodes, so large that its largest displacement is `amplitude`.
void add_shape(const Model& model, const std::vector<Vec6>& shape, double amplitude, StartChange& change);

// Adds displacements by `lean` times the height above the lowest node, along the unit vector `up`. Sections
// turn with their lines.
void add_sway(const Model& model, const Vec3& up, const Vec3& lean, StartChange& change);

// Adds half a sine wave across the chord of a member, whose rise is `bow` times its length, towards a
// direction; returns false if that is along it.
bool add_bow(
    const Model& model, const Member& member, double bow, const Vec3& direction, StartChange& change);

}  // namespace gxrod
