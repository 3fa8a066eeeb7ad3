#pragma once

#include <string>

#include "model/model.hpp"
#include "model/settings/settings.hpp"

// Lines about rods in water at rest: tension, boundary layers, frequency and vortices. Empty for models of
// more than 50 rods.
namespace gxrod {

// Describes the estimates for a rod in water; "" for other rods, or if there is no estimate.
std::string describe_line_at_rest(const Model& model, const Rod& rod);

// Says why moments near the ends of a rod, or where it leaves the ground, are not resolved, and what would
// resolve them; "" if they are resolved, or if their layer is thinner than the rod.
std::string find_coarse_layer(const Model& model, const Rod& rod);

// Says that a current sheds vortices at about a natural frequency of a rod; "" if it does not.
std::string find_vortices(const Model& model, const Rod& rod, const AnalysisSettings& analysis);

}  // namespace gxrod
