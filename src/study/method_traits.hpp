#pragma once

#include <vector>

#include "model/model.hpp"
#include "model/settings/settings.hpp"

// Properties of the methods of a deck that its study uses.
namespace gxrod {

// Returns the settings of adaptive steps; null if steps are equal.
const AdaptiveSettings* adaptive_of(const AnalysisSettings& analysis);

// Returns the order of the scheme in the step; 1 in statics.
double order_of(const AnalysisSettings& analysis);

// Returns the lowest order of the elements; 4 without rods.
int lowest_order_of(const Model& model);
bool has_elements_simo(const Model& model);

// Chooses the times at which a study compares runs: ends of steps, at most 2001. With adaptive steps, whose
// number is not known in advance, 1001 equally spaced times.
std::vector<double> choose_times(const AnalysisSettings& analysis);

}  // namespace gxrod
