#include "cross_section/examination/segment_crossing.hpp"

#include <cmath>

namespace gxrod {
namespace {

// Crossings closer to an end than this, over the length, do not count: segments that follow each other meet.
constexpr double at_an_end = 1e-7;

double wedge(const PlanePoint& a, const PlanePoint& b) { return a.x() * b.y() - a.y() * b.x(); }

std::pair<double, double> segment_range(const PlaneSegment& segment, int axis) {
    return std::minmax({segment.from[axis], segment.to[axis]});
}

}  // namespace

std::optional<PlanePoint> find_crossing(const PlaneSegment& a, const PlaneSegment& b) {
    const PlanePoint along_a = a.to - a.from, along_b = b.to - b.from, between = b.from - a.from;
    const double determinant = wedge(along_a, along_b);
    if (std::abs(determinant) <= 1e-12 * along_a.norm() * along_b.norm()) return std::nullopt;
    const double on_a = wedge(between, along_b) / determinant;
    const double on_b = wedge(between, along_a) / determinant;
    const auto is_within = [](double place) { return place > at_an_end && place < 1.0 - at_an_end; };
    if (!is_within(on_a) || !is_within(on_b)) return std::nullopt;
    return a.from + on_a * along_a;
}

std::optional<SegmentCrossing> find_crossing(std::vector<PlaneSegment> segments) {
    // Swept along y: a segment meets those that begin before it ends.
    std::ranges::sort(segments, {}, [](const PlaneSegment& one) { return segment_range(one, 0).first; });
    for (std::size_t i = 0; i < segments.size(); ++i) {
        const double last = segment_range(segments[i], 0).second;
        const auto [low, high] = segment_range(segments[i], 1);
        for (std::size_t j = i + 1; j < segments.size() && segment_range(segments[j], 0).first < last; ++j) {
            const auto [other_low, other_high] = segment_range(segments[j], 1);
            if (other_low > high || other_high < low) continue;
            if (const auto at = find_crossing(segments[i], segments[j]))
                return SegmentCrossing{segments[i], segments[j], *at};
        }
    }
    return std::nullopt;
}

}  // namespace gxrod
