#pragma once

#include <string>
#include <vector>

#include "model/model.hpp"

namespace gxrod {

// A sentence for each place where an end of a rod coincides with another node, of a rod or body, that is not
// the same node: what is there, and what a deck has to say to connect it. Places where all nodes are wholly
// held are left out.
std::vector<std::string> find_unconnected_points(const Model& model);

}  // namespace gxrod
