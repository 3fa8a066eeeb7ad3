#pragma once

#include <cstdint>
#include <limits>
#include <vector>

namespace gxrod {

// How near a motion may bring what touches: as increments (of pairs find_kept_share, else to a tenth of the
// gap) or as predictions (find_predicted_share).
enum class Approach { increment, prediction };

// The part of an increment that each part of the model may make (ScaleGroups).
struct ContactLimits {
    std::vector<double> of_parts;  // 0 … 1
    double least = 1.0;
    double least_gap = std::numeric_limits<double>::infinity();  // before the increment

    bool shorten() const { return least < 1.0; }
};

// What touches at an instant.
struct ContactCount {
    std::int64_t touching = 0;
    double least_gap = 0.0;
};

}  // namespace gxrod
