#pragma once

#include "rotation/types.hpp"

// The closest points of two straight segments.
namespace gxrod {

// Vectors and matrices by the positions of the four ends of two segments.
using Vec12 = Eigen::Matrix<double, 12, 1>;
using Row12 = Eigen::Matrix<double, 1, 12>;
using Mat312 = Eigen::Matrix<double, 3, 12>;

// The points start + s (end − start), s in [0, 1]. Both ends may coincide.
struct Segment {
    Vec3 start, end;

    Vec3 at(double s) const { return start + s * (end - start); }
    bool operator==(const Segment&) const = default;
};

struct ClosestPoints {
    double s = 0.0, t = 0.0;  // parameters on the first and on the second segment
    double distance = 0.0;
    Vec3 offset = Vec3::Zero();  // from the second segment's point to the first's
};

// Finds the closest points; for parallel segments, one of the closest pairs.
ClosestPoints find_closest_points(const Segment& a, const Segment& b);

// Whether the segments are nearer than this; fast for distant segments.
bool are_within(const Segment& a, const Segment& b, double distance);

}  // namespace gxrod
