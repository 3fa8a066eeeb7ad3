#pragma once

#include <functional>

#include "run/stepped_run.hpp"

namespace gxrod {

// Runs as run_analysis does, and shows the run at its end, before its results file is complete. If `at_end`
// throws, the file is completed and the exception passed on.
RunSummary run_to_end(const RunRequest& request, const std::function<void(const SteppedRun&)>& at_end);

}  // namespace gxrod
