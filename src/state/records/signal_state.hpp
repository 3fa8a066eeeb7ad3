#pragma once

namespace gxrod {

// The memory of a signal from step to step; part of the data for resuming a run.
struct SignalState {
    double measured = 0.0;    // at the last accepted step
    double is_started = 0.0;  // 1 once it was set
    double time = 0.0;        // when it was set last, on the axis that stages share
    double filtered = 0.0;    // behind the filter, then
    double integral = 0.0;    // of the error, up to then
    double largest = 0.0;     // its largest size so far
};

}  // namespace gxrod
