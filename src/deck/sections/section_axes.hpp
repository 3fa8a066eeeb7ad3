#pragma once

#include <optional>

#include "deck/places/build_context.hpp"

// The section axes of rods at t = 0.
namespace gxrod {

// Finds the axes at the start, from the unit tangent and a table's y_axis or, with a note, a global axis. If
// y_axis is wrong, adds a fault and returns nullopt.
std::optional<Quat> find_start_axes(const TableHead& table,
                                    const std::optional<Vec3>& y_axis,
                                    const Vec3& tangent,
                                    BuildContext& context);

// Chooses axes from a unit tangent and the global axis least aligned with it.
Quat choose_axes(const Vec3& tangent);

// Computes axes from a unit tangent and a direction of section y, projected; nullopt if they are parallel.
std::optional<Quat> project_axes(const Vec3& tangent, const Vec3& y_axis);

// Returns axes turned about their x by an angle.
Quat twisted(const Quat& axes, double angle);

}  // namespace gxrod
