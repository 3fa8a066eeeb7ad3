#pragma once

#include <string>

#include "model/model.hpp"
#include "model/settings/settings.hpp"

// Lines for a reader on rods in water at rest: tension, boundary layers, frequency and vortices. Empty of
// models of more than 50 rods.
namespace gxrod {

// What is estimated of a rod in water; "" of one that is not, or of which nothing can be said.
std::string describe_line_at_rest(const Model& model, const Rod& rod);

// Why moments near the ends of a rod, or where it leaves the ground, are not resolved, and what would; "" if
// they are, or if the layer in which they are is thinner than the rod.
std::string find_coarse_layer(const Model& model, const Rod& rod);

// That a current sheds vortices at about a natural frequency of a rod; "" if it does not.
std::string find_vortices(const Model& model, const Rod& rod, const AnalysisSettings& analysis);

}  // namespace gxrod
