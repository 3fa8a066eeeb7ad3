#pragma once

#include <algorithm>
#include <limits>

#include "contact/pairs/closest_points.hpp"

// How far a motion can go before a gap has closed: conservative advancement. Motions run from t = 0 to 1.
// Every step is proved to be free, so it is safe to stop early.
namespace gxrod {

struct AdvancementLimits {
    double kept_share = 0.1;    // of the gap at the start; the gap never falls below it
    double tolerance = 0.05;    // the motion ends where the gap exceeds that by less than this part of it
    int most_evaluations = 64;  // of the gap; then the motion ends where it is proved free
};

struct Advancement {
    double fraction = 1.0;  // of the motion; 0 if there is no gap at the start
    int evaluations = 0;
};

// measure(t) returns what has `gap` and `find_free_motion(floor)`: by how much t can at least grow before the
// gap falls below the floor.
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

// What measure(t) can return of a gap that closes by no more than `speed` times the change of t.
struct GapAndSpeed {
    double gap, speed;
    double find_free_motion(double floor) const {
        return speed > 0.0 ? (gap - floor) / speed : std::numeric_limits<double>::infinity();
    }
};

// Two capsules whose ends move on straight lines; `radii` is the sum of both radii. A segment without length
// is a ball. How the capsules move together, and along each other, costs nothing: only what closes the gap
// counts.
Advancement advance_capsules(const Segment& a_start,
                             const Segment& a_end,
                             const Segment& b_start,
                             const Segment& b_end,
                             double radii,
                             const AdvancementLimits& limits = {});

}  // namespace gxrod
