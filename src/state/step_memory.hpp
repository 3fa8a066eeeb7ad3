#pragma once

#include <cstdint>

namespace gxrod {

// The place in a sequence of steps, enough to resume it.
struct StepMemory {
    bool has_failed = false;   // even with the shortest step after `time`
    double time = 0.0;         // end of the last accepted step
    bool is_off_grid = false;  // whether `time` is not one of the times of equal steps
    double lead = 0.0;         // part of the next step for which a settled state has crept already
    // If steps are chosen by their error:
    double step = 0.0;           // to try next, before it is fitted to the time that is left; 0: not known
    double error_before = -1.0;  // error of the last accepted step over its tolerance; negative: not known
    bool just_rejected = false;
    std::int64_t accepted = 0;  // steps
};

}  // namespace gxrod
