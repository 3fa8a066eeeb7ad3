#pragma once

#include "study/motion_trace.hpp"

namespace gxrod {

// The outcome of stopping a run midway and resuming it.
struct ResumedRun {
    double stopped_at = 0.0;
    std::vector<double> times;                  // times of accepted steps after the stop
    std::vector<std::vector<HistoryRow>> rows;  // rows of all series, for each of these steps
    long steps = 0;
    long rejected_steps = 0;
    long newton_iterations = 0;
    double seconds = 0.0;
    std::string failure;
};

// Runs the problem into a file in a folder for temporary files until half of `end_time`, in its last stage,
// and resumes from this file. Throws FileError, StudyInterrupted.
ResumedRun run_with_stop(const Problem& problem, double end_time, const TraceRequest& request);

}  // namespace gxrod
