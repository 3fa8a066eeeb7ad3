#pragma once

#include "model/model.hpp"

namespace gxrod {

// Estimates the most memory of a run in bytes, if its results file gets `results_bytes`: with the default
// solver, within a third of measured values (docs/performance.md).
double estimate_memory(const Model& model, double results_bytes);

}  // namespace gxrod
