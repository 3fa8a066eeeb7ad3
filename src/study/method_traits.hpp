#pragma once

#include <vector>

#include "model/model.hpp"
#include "model/settings/settings.hpp"

// What a study of a deck knows beforehand of its methods.
namespace gxrod {

// Nothing if steps are equal.
const AdaptiveSettings* adaptive_of(const AnalysisSettings& analysis);

// Of the scheme, in the step; 1 in statics.
double order_of(const AnalysisSettings& analysis);

// Of the elements; 4 without rods.
int lowest_order_of(const Model& model);
bool has_elements_simo(const Model& model);

// Where a study compares runs: at the ends of steps, at most 2001 times. With steps by their error, whose
// number is not known beforehand, at 1001 even times.
std::vector<double> choose_times(const AnalysisSettings& analysis);

}  // namespace gxrod
