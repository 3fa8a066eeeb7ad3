#pragma once

#include <functional>
#include <string>
#include <vector>

#include "model/model.hpp"
#include "state/motion.hpp"

namespace gxrod {

// A load that is drawn at a node: its force and moment, per length for a load along a rod.
struct LoadArrow {
    std::string key;  // "load[0]"
    int node = 0;
    bool is_along_rod = false;
    // Spatial force and moment, stacked, for this motion of the node at a time. Throws EvaluationError.
    std::function<Vec6(const NodeMotion&, double time)> value;
};

// Lists every load at a point, and each load along a rod at a few of its nodes. The model must outlive them.
std::vector<LoadArrow> list_load_arrows(const Model& model);

}  // namespace gxrod
