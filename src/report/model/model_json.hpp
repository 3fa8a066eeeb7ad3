#pragma once

#include <functional>
#include <nlohmann/json_fwd.hpp>
#include <vector>

#include "deck/problem.hpp"

// Descriptions of the model for the page's texts and drawings.
namespace gxrod {

// Returns the number in the page of a node of the model.
using NodeNumbers = std::function<int(int)>;

// Describes water with a surface: its height at rest, and waves, each with amplitude, kx, ky, frequency and
// phase, that grow over `ramp` from `ramp_start` on. Describes ground: a point and the normal of the plane,
// or the heights of the grid, and the radius of each rod, 0 for rods that ignore the ground.
nlohmann::ordered_json describe_surroundings(const Problem& problem);

// Describes at most `most` bodies as cuboids of their mass and inertia: name, node, position of the centre of
// mass from the node (body axes), axes of the cuboid in body axes (quaternion w x y z), half sizes, attitude
// at t = 0.
nlohmann::ordered_json describe_bodies(const Model& model, const NodeNumbers& number, std::size_t most);

// Describes at most `most` supports: name of the node, node, axes (quaternion w x y z), fixed and moved
// components.
nlohmann::ordered_json describe_supports(const Model& model, const NodeNumbers& number, std::size_t most);

// Describes at most `most` joints: name, type, ends, axes at t = 0 that A carries (quaternion w x y z; x is
// the joint's axis), for a universal joint also the axis that B carries; `moved` if a motor moves it. Ends
// are A and B, each a node and the arm from it to the point, global at t = 0; for the ground -1 and the point
// itself.
nlohmann::ordered_json describe_joints(const Model& model, const NodeNumbers& number, std::size_t most);

// Adds a list for each kind of tie that is an element, "springs" and so on, of at most `most` each: name,
// ends as for joints; `pulls` of a spring unless it is only a damper; axes of a bushing at t = 0 (quaternion
// w x y z).
void describe_element_ties(const Model& model,
                           const NodeNumbers& number,
                           std::size_t most,
                           nlohmann::ordered_json& json);

// Returns tables of the model and of the analysis for a reader: [{title, columns, rows}], cells are texts and
// numbers.
nlohmann::ordered_json describe_tables(const Problem& problem);

// Counts the unknowns of the system of equations: six per node without components that supports hold.
std::size_t count_unknowns(const Model& model);

}  // namespace gxrod
