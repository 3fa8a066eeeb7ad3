#include "contact/pairs/closest_points.hpp"

#include <algorithm>
#include <cmath>

// Legend: A, B the segments' vectors, r from the start of b to that of a; the squared distance is the convex
// |r + s A − t B|². Its least value is inside the square of (s, t), or on one of its four sides.
namespace gxrod {
namespace {

// The quotient in [0, 1]; 0 if there is nothing to divide by.
double clamp_quotient(double numerator, double denominator) {
    return denominator > 0.0 ? std::clamp(numerator / denominator, 0.0, 1.0) : 0.0;
}

// Below this sin² of the angle, the least distance inside differs from that on the sides by rounding.
constexpr double least_sine_squared = 1e-14;

}  // namespace

ClosestPoints find_closest_points(const Segment& a, const Segment& b) {
    const Vec3 A = a.end - a.start, B = b.end - b.start, r = a.start - b.start;
    const double AA = A.squaredNorm(), AB = A.dot(B), BB = B.squaredNorm(), Ar = A.dot(r), Br = B.dot(r);
    const auto make = [&](double s, double t) {
        const Vec3 offset = r + s * A - t * B;
        return ClosestPoints{s, t, offset.norm(), offset};
    };
    // det is |A × B|², whose digits the difference would lose.
    const double det = A.cross(B).squaredNorm();
    if (det > least_sine_squared * AA * BB) {
        const double s = (AB * Br - BB * Ar) / det;
        // Of a small angle, s is less exact than t that belongs to it.
        const double t = (s * AB + Br) / BB;
        if (s >= 0.0 && s <= 1.0 && t >= 0.0 && t <= 1.0) return make(s, t);
    }
    const auto square = [&](double s, double t) {
        return s * (s * AA + 2.0 * (Ar - t * AB)) + t * (t * BB - 2.0 * Br);
    };
    const double sides[4][2] = {{0.0, clamp_quotient(Br, BB)},
                                {1.0, clamp_quotient(AB + Br, BB)},
                                {clamp_quotient(-Ar, AA), 0.0},
                                {clamp_quotient(AB - Ar, AA), 1.0}};
    int best = 0;
    double least = square(sides[0][0], sides[0][1]);
    for (int side = 1; side < 4; ++side) {
        const double value = square(sides[side][0], sides[side][1]);
        if (value < least) best = side, least = value;
    }
    return make(sides[best][0], sides[best][1]);
}

bool are_within(const Segment& a, const Segment& b, double distance) {
    const double reach = distance + 0.5 * ((a.end - a.start).norm() + (b.end - b.start).norm());
    const Vec3 between = 0.5 * (a.start + a.end - b.start - b.end);
    return between.squaredNorm() < reach * reach && find_closest_points(a, b).distance < distance;
}

}  // namespace gxrod
