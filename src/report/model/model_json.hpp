#pragma once

#include <functional>
#include <nlohmann/json_fwd.hpp>
#include <vector>

#include "deck/problem.hpp"

// What the page says and draws of the model.
namespace gxrod {

// Where a node of the model went in the page.
using NodeNumbers = std::function<int(int)>;

// Where there is water with a surface: its height at rest, and waves, each amplitude, kx, ky, frequency and
// phase, that grow over `ramp` from `ramp_start` on. Where there is ground: a point and the normal of the
// plane, or the heights of the grid, and the radius of each rod, 0 of one that does not see the ground.
nlohmann::ordered_json describe_surroundings(const Problem& problem);

// At most `most` bodies, as cuboids of their mass and inertia: name, node, position of the centre of mass
// from the node (body axes), axes of the cuboid in those of the body (quaternion w x y z), half sizes,
// attitude at t = 0.
nlohmann::ordered_json describe_bodies(const Model& model, const NodeNumbers& number, std::size_t most);

// At most `most` supports: name of the node, node, axes (quaternion w x y z), fixed and moved components.
nlohmann::ordered_json describe_supports(const Model& model, const NodeNumbers& number, std::size_t most);

// At most `most` joints: name, type, ends, axes at t = 0 that A carries (quaternion w x y z; x is the joint's
// axis), of a universal joint also the axis that B carries; `moved` if a motor moves it. Ends are A and B,
// each a node, -1 for the ground, and the arm from it to the point, global at t = 0; of the ground the point
// itself.
nlohmann::ordered_json describe_joints(const Model& model, const NodeNumbers& number, std::size_t most);

// At most `most` springs: name, ends as those of joints; `pulls` unless it is a damper alone.
nlohmann::ordered_json describe_springs(const Model& model, const NodeNumbers& number, std::size_t most);

// At most `most` bushings: name, ends as those of joints, axes at t = 0 (quaternion w x y z).
nlohmann::ordered_json describe_bushings(const Model& model, const NodeNumbers& number, std::size_t most);

// Tables of the model and of the analysis for a reader: [{title, columns, rows}], cells are texts and
// numbers.
nlohmann::ordered_json describe_tables(const Problem& problem);

// Unknowns of the system of equations: six a node less those that supports hold.
std::size_t count_unknowns(const Model& model);

}  // namespace gxrod
