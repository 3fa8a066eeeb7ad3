#pragma once

#include <algorithm>
#include <limits>

#include "contact/pairs/closest_points.hpp"

// Finds how far a motion can go before a gap has closed, by conservative advancement. Motions run from t = 0
// to 1. Every step is proved to be free, so it is safe to stop early.
namespace gxrod {

struct AdvancementLimits {
    double kept_share = 0.1;  // share of the gap at the start; the gap never falls below it
    double tolerance =
        0.05;  // the motion ends if the gap exceeds the kept share by less than this part of it
    int most_evaluations = 64;  // evaluations of the gap; the motion then ends where it is proved free
};

struct Advancement {
    double fraction = 1.0;  // part of the motion; 0 if there is no gap at the start
    int evaluations = 0;
};

// Advances with measure(t), which returns an object with `gap` and `find_free_motion(floor)`: the least
// growth of t at which the gap could fall below the floor.
template <class Measure>
Advancement advance(const Measure& measure, const AdvancementLimits& limits = {}) {
    auto here = measure(0.0);
    Advancement result{0.0, 1};
    if (!(here.gap > 0.0)) return result;
    const double floor = limits.kept_share * here.gap;
    const double stop = (1.0 + limits.tolerance) * floor;
    while (true) {
        result.fraction += here.find_free_motion(floor);
        if (result.fraction >= 1.0 || result.evaluations >= limits.most_evaluations) break;
        here = measure(result.fraction);
        ++result.evaluations;
        if (here.gap <= stop) break;
    }
    result.fraction = std::min(result.fraction, 1.0);
    return result;
}

// A result of measure(t) for a gap that closes by no more than `speed` times the change of t.
struct GapAndSpeed {
    double gap, speed;
    double find_free_motion(double floor) const {
        return speed > 0.0 ? (gap - floor) / speed : std::numeric_limits<double>::infinity();
    }
};

// Advances two capsules whose ends move on straight lines; `radii` is the sum of both radii. A segment
// without length is a ball. Only motion that closes the gap counts, not motion of both together or along each
// other.
Advancement advance_capsules(const Segment& a_start,
                             const Segment& a_end,
                             const Segment& b_start,
                             const Segment& b_end,
                             double radii,
                             const AdvancementLimits& limits = {});

}  // namespace gxrod
