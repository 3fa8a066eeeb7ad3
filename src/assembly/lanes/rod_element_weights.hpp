#pragma once

#include <vector>

#include "model/model.hpp"

namespace gxrod {

// Integrals of the shape functions of an element of a rod by its length at t = 0, by Gauss' rule of as many
// points as nodes.
struct RodElementWeights {
    std::vector<double> lengths;   // ∫ N_I ds
    std::vector<double> products;  // ∫ N_I N_J ds, column by column
};
RodElementWeights compute_element_weights(const Model& model, const Rod& rod, int element);

}  // namespace gxrod
