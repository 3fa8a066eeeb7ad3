#pragma once

#include <string>
#include <vector>

#include "assembly/system.hpp"

namespace gxrod {

// A place where a residual is large: a node, its worst component (0 … 5, in its support's axes if it has its
// own) and the residual there over the scale of forces or moments.
struct WorstNode {
    int node = -1;
    int component = -1;
    double residual = 0.0;
};

// Finds at most `count` nodes where a residual is largest, the worst first, each once; none if it vanishes.
// NaN comes first.
std::vector<WorstNode> find_worst_nodes(const System& system, const Residual& residual, std::size_t count);

// Returns a name such as "flyer.end (ry)".
std::string name_place(const Model& model, int node, int component);

}  // namespace gxrod
