#pragma once

#include <functional>

#include "batch/case_run.hpp"

namespace gxrod {

// Reads and builds every case, so that what is wrong with one shows before any is run, and returns the
// problem of the first. `report` hears how many were examined. Throws DeckError, each fault once, with the
// cases that have it, at the plan's key where that gave the value; FileError where a mesh cannot be read.
Problem check_cases(const CaseContext& context, const std::function<void(long)>& report);

}  // namespace gxrod
