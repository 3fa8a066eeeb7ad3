#pragma once

#include "verification/study.hpp"

namespace gxrod::rubin2007 {

// Runs the study over options.steps (default 50, 100, …, 1600) and reports it as a table and JSON.
StudyResult report(const StudyOptions& options);

}  // namespace gxrod::rubin2007
