#pragma once

#include <string>
#include <vector>

#include "model/model.hpp"

namespace gxrod {

// Lists a sentence for each place where an end of a rod coincides with a different node of a rod or body: the
// parts there, and the key of a deck that connects them. Places where all nodes are wholly held are left out.
std::vector<std::string> find_unconnected_points(const Model& model);

}  // namespace gxrod
