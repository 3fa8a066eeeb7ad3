#pragma once

#include <cstdint>
#include <limits>
#include <vector>

namespace gxrod {

// The kind of motion that contact limits: increments (pairs by find_kept_share, others to a tenth of the gap)
// or predictions (find_predicted_share).
enum class Approach { increment, prediction };

// The admissible share of an increment for each part of the model (ScaleGroups).
struct ContactLimits {
    std::vector<double> of_parts;  // 0 … 1
    double least = 1.0;
    double least_gap = std::numeric_limits<double>::infinity();  // before the increment

    bool shorten() const { return least < 1.0; }
};

// Numbers of contact at an instant.
struct ContactCount {
    std::int64_t touching = 0;
    double least_gap = 0.0;
};

}  // namespace gxrod
