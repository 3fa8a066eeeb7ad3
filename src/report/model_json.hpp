#pragma once

#include <functional>
#include <nlohmann/json_fwd.hpp>
#include <vector>

#include "deck/problem.hpp"

// What the page says and draws of the model.
namespace gxrod {

// Where a node of the model went in the page.
using NodeNumbers = std::function<int(int)>;

// At most `most` bodies, as cuboids of their mass and inertia: name, node, position of the centre of mass
// from the node (body axes), axes of the cuboid in those of the body (quaternion w x y z), half sizes,
// attitude at t = 0.
nlohmann::ordered_json describe_bodies(const Model& model, const NodeNumbers& number, std::size_t most);

// At most `most` supports: name of the node, node, axes (quaternion w x y z), fixed and moved components.
nlohmann::ordered_json describe_supports(const Model& model, const NodeNumbers& number, std::size_t most);

// Tables of the model and of the analysis for a reader: [{title, columns, rows}], cells are texts and
// numbers.
nlohmann::ordered_json describe_tables(const Problem& problem);

// Unknowns of the system of equations: six a node less those that supports hold.
std::size_t count_unknowns(const Model& model);

}  // namespace gxrod
