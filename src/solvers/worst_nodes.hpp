#pragma once

#include <string>
#include <vector>

#include "assembly/system.hpp"

namespace gxrod {

// Where a residual is large: a node, the worst of its components (0 … 5, in its support's axes if it has its
// own) and its size there over the scale of forces or moments.
struct WorstNode {
    int node = -1;
    int component = -1;
    double residual = 0.0;
};

// The nodes where a residual is largest, the worst first, each once; at most `count`, none where it vanishes.
// NaN comes first.
std::vector<WorstNode> find_worst_nodes(const System& system, const Residual& residual, std::size_t count);

// "flyer.end (ry)".
std::string name_place(const Model& model, int node, int component);

}  // namespace gxrod
