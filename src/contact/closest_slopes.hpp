#pragma once

#include "contact/closest_points.hpp"

namespace gxrod {

// How the closest points x(s) and y(t) of two segments follow their ends, where they are inside.
struct ClosestSlopes {
    double shares[4];        // of the ends in x − y
    Vec12 along_a, along_b;  // derivatives of (x − y) · A and (y − x) · B at the same s and t
    Vec12 s_by = Vec12::Zero(), t_by = Vec12::Zero();

    ClosestSlopes(const Segment& a, const Segment& b, const ClosestPoints& closest)
        : shares{1.0 - closest.s, closest.s, closest.t - 1.0, -closest.t} {
        const Vec3 &x = closest.offset, A = a.end - a.start, B = b.end - b.start;
        constexpr double by_s[4] = {-1.0, 1.0, 0.0, 0.0}, by_t[4] = {0.0, 0.0, 1.0, -1.0};
        for (int i = 0; i < 4; ++i) {
            along_a.segment<3>(3 * i) = by_s[i] * x + shares[i] * A;
            along_b.segment<3>(3 * i) = by_t[i] * x - shares[i] * B;
        }
        const bool inside_a = closest.s > 0.0 && closest.s < 1.0;
        const bool inside_b = closest.t > 0.0 && closest.t < 1.0;
        const double AA = A.squaredNorm(), BB = B.squaredNorm(), AB = A.dot(B);
        if (inside_a && inside_b) {
            const double det = A.cross(B).squaredNorm();
            if (det <= 1e-14 * AA * BB) return;
            s_by = -(BB * along_a + AB * along_b) / det;
            t_by = -(AB * along_a + AA * along_b) / det;
        } else if (inside_a) {
            s_by = -along_a / AA;
        } else if (inside_b) {
            t_by = -along_b / BB;
        }
    }

    Mat312 find_offset_by(const Segment& a, const Segment& b) const {
        Mat312 by = (a.end - a.start) * s_by.transpose() - (b.end - b.start) * t_by.transpose();
        for (int end = 0; end < 4; ++end) by.middleCols<3>(3 * end).diagonal().array() += shares[end];
        return by;
    }
};

}  // namespace gxrod
