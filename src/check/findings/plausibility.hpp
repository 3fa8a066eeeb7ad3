#pragma once

#include <vector>

#include "check/findings/finding.hpp"
#include "model/settings/stage.hpp"

namespace gxrod {

// Asks about numbers that hardly any model has, such as numbers in another unit (`gxrod check`). These
// findings are notes: the model is computed as it stands.
std::vector<Finding> question_model(const Model& model, const std::vector<StagePlan>& stages);

}  // namespace gxrod
