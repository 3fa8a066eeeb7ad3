#pragma once

#include <string>

#include "model/model.hpp"

namespace gxrod {

// Connections, supports, initial velocities, loads and gravity of a model, in lines for a reader.
std::string describe_conditions(const Model& model);

}  // namespace gxrod
