#pragma once

#include <vector>

#include "model/settings/settings.hpp"

namespace gxrod {

// Returns the times of an analysis's steps, from 0 to its end; `most` + 1 of them, evenly spread, if there
// are more than `most` steps.
std::vector<double> sample_times(const AnalysisSettings& analysis, long most);

}  // namespace gxrod
