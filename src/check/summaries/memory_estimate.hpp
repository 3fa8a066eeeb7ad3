#pragma once

#include "model/model.hpp"

namespace gxrod {

// About how many bytes of memory a run has at most, whose results file gets so many bytes: with the default
// solver, within a third of what was measured (docs/performance.md).
double estimate_memory(const Model& model, double results_bytes);

}  // namespace gxrod
