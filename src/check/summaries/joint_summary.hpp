#pragma once

#include <string>

#include "check/summaries/item_list.hpp"
#include "model/model.hpp"

namespace gxrod {

// Describes an anchor: "the ground at (0, 0, 1)", "arm.end", "engine by an arm of 0.12 to (0, 0.4, 0)".
std::string describe_anchor(const Model& model, const Anchor& anchor);

// Lists a line for each joint: its place, its parts, and the actions on its coordinates.
ItemList list_joints(const Model& model);

// Lists a line for each gear: "gear stage: 5 × turn of shaft + turn of wheel = 0".
ItemList list_gears(const Model& model);

}  // namespace gxrod
