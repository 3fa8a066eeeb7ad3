#pragma once

#include <string>
#include <vector>

#include "model/model.hpp"

namespace gxrod {

// Rods and bodies that share nodes, directly or by way of others. All indices are those of the model.
struct ConnectedPart {
    std::vector<int> nodes;
    std::vector<int> rods;
    std::vector<int> bodies;
};

// The parts of a model in the order of their first nodes. A rod of a mesh may be in several.
std::vector<ConnectedPart> find_connected_parts(const Model& model);

// "rod cable", "rods leg and beam, body tip".
std::string describe_part(const Model& model, const ConnectedPart& part);

}  // namespace gxrod
