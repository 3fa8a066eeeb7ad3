#pragma once

#include "rotation/types.hpp"

// Where two straight segments are closest.
namespace gxrod {

// By the positions of the four ends of two segments.
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
    double s = 0.0, t = 0.0;  // on the first and on the second segment
    double distance = 0.0;
    Vec3 offset = Vec3::Zero();  // from the point of the second segment to that of the first
};

// Of parallel segments one of the closest pairs.
ClosestPoints find_closest_points(const Segment& a, const Segment& b);

// Whether they are nearer than this; quick where they are far apart.
bool are_within(const Segment& a, const Segment& b, double distance);

}  // namespace gxrod
