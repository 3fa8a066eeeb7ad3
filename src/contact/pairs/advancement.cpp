#include "contact/pairs/advancement.hpp"

namespace gxrod {
namespace {

Segment interpolate(const Segment& from, const Segment& to, double t) {
    return {from.start + t * (to.start - from.start), from.end + t * (to.end - from.end)};
}

// Where the capsules are, the normal n between the closest points separates them: two ends x of a and y of b
// have n·(x − y) ≥ distance. As long as that holds for all four pairs of ends with less than the distance,
// all of a is at least so far from all of b; and n·(x − y) is linear in t.
struct SeparatedCapsules {
    double gap;
    double radii;
    double heights[4];  // n·(x − y)
    double rates[4];    // their derivatives by t

    double find_free_motion(double floor) const {
        double free = std::numeric_limits<double>::infinity();
        for (int pair = 0; pair < 4; ++pair)
            if (rates[pair] < 0.0) free = std::min(free, (heights[pair] - radii - floor) / -rates[pair]);
        return std::max(free, 0.0);
    }
};

}  // namespace

// a_start is where a is at t = 0, a_end where it is at t = 1.
Advancement advance_capsules(const Segment& a_start,
                             const Segment& a_end,
                             const Segment& b_start,
                             const Segment& b_end,
                             double radii,
                             const AdvancementLimits& limits) {
    const Vec3 motions[4] = {a_end.start - a_start.start,
                             a_end.end - a_start.end,
                             b_end.start - b_start.start,
                             b_end.end - b_start.end};
    return advance(
        [&](double t) {
            const Segment a = interpolate(a_start, a_end, t), b = interpolate(b_start, b_end, t);
            const ClosestPoints closest = find_closest_points(a, b);
            SeparatedCapsules here{closest.distance - radii, radii, {}, {}};
            if (closest.distance == 0.0) return here;  // no gap
            const Vec3 n = closest.offset / closest.distance;
            const double ends[4] = {n.dot(a.start), n.dot(a.end), n.dot(b.start), n.dot(b.end)};
            const double rates[4] = {
                n.dot(motions[0]), n.dot(motions[1]), n.dot(motions[2]), n.dot(motions[3])};
            for (int i = 0; i < 2; ++i)
                for (int j = 0; j < 2; ++j) {
                    here.heights[2 * i + j] = ends[i] - ends[2 + j];
                    here.rates[2 * i + j] = rates[i] - rates[2 + j];
                }
            return here;
        },
        limits);
}

}  // namespace gxrod
