#pragma once

#include <string>
#include <vector>

#include "model/model.hpp"

namespace gxrod {

// Lists a sentence for each bushing whose axes turn half way with a part that spins about a direction that
// the bushing leaves free: a bearing needs axes of its own.
std::vector<std::string> find_turning_bushings(const Model& model);

}  // namespace gxrod
