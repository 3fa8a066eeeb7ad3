#pragma once

#include <memory>
#include <vector>

#include "constraints/joints/wide_rows.hpp"
#include "model/model.hpp"

namespace gxrod {

// Lists the equations of a model over several nodes, such as gears, in the order of their states and values,
// which follow those of Model::joints.
std::vector<std::unique_ptr<const WideRows>> list_wide_rows(const Model& model);

}  // namespace gxrod
