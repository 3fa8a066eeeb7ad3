#pragma once

#include <vector>

#include "check/findings/finding.hpp"
#include "model/model.hpp"

namespace gxrod {

// Notes where the stiffness of a shape on cells is that of another rod than the model's: where warping that
// is held at an end reaches far along it, and where the rod is curved or twisted much compared with its
// section.
std::vector<Finding> question_shapes(const Model& model);

}  // namespace gxrod
