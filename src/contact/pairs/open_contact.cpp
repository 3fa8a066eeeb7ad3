#include "contact/pairs/open_contact.hpp"

#include <Eigen/LU>

namespace gxrod {
namespace {

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

// A segment as a direction and a length, with its derivatives by all four ends.
struct Line {
    Vec3 direction = Vec3::Zero();
    double length = 0.0;
    Mat312 direction_by = Mat312::Zero();
    Row12 length_by = Row12::Zero();

    Line(const Segment& segment, int first_end) : length((segment.end - segment.start).norm()) {
        if (length == 0.0) return;
        direction = (segment.end - segment.start) / length;
        const Mat3 turn = (Mat3::Identity() - direction * direction.transpose()) / length;
        direction_by.middleCols<3>(3 * first_end) = -turn;
        direction_by.middleCols<3>(3 * first_end + 3) = turn;
        length_by.segment<3>(3 * first_end) = -direction.transpose();
        length_by.segment<3>(3 * first_end + 3) = direction.transpose();
    }
};

bool goes_on(double place, bool open_start, bool open_end) {
    return place == 0.0 ? open_start : place < 1.0 || open_end;
}

}  // namespace

OpenContact find_open_contact(const Segment& a, const Segment& b, const OpenEnds& open) {
    const ClosestPoints closest = find_closest_points(a, b);
    const ClosestSlopes slopes(a, b, closest);
    const Line of_a(a, 0), of_b(b, 2);
    OpenContact result;
    result.inside = closest;
    result.s = closest.s, result.t = closest.t;
    result.s_by = slopes.s_by, result.t_by = slopes.t_by;
    result.offset = closest.offset;
    result.offset_by = slopes.find_offset_by(a, b);
    const double cosine = of_a.direction.dot(of_b.direction);
    const Row12 cosine_by =
        of_a.direction.transpose() * of_b.direction_by + of_b.direction.transpose() * of_a.direction_by;
    // Of sin² of the angle between the lines.
    constexpr double half_at = 3e-4;
    const double square = 1.0 - cosine * cosine, fourth = square * square;
    result.crossing = fourth / (fourth + half_at);
    result.crossing_by =
        -4.0 * half_at * square * cosine / ((fourth + half_at) * (fourth + half_at)) * cosine_by.transpose();
    const bool is_free_a = of_a.length > 0.0 && goes_on(closest.s, open.a_start, open.a_end);
    const bool is_free_b = of_b.length > 0.0 && goes_on(closest.t, open.b_start, open.b_end);
    // What is along both is taken off; nothing is where the closest points are inside.
    Eigen::Vector2d along = Eigen::Vector2d::Zero();
    Eigen::Matrix<double, 2, 12> along_by = Eigen::Matrix<double, 2, 12>::Zero();
    const auto take = [&](int row, const Line& line) {
        along[row] = line.direction.dot(closest.offset);
        along_by.row(row) =
            line.direction.transpose() * result.offset_by + closest.offset.transpose() * line.direction_by;
    };
    if (is_free_a) take(0, of_a);
    if (is_free_b) take(1, of_b);
    Eigen::Vector2d off = along;
    Eigen::Matrix<double, 2, 12> off_by = along_by;
    if (is_free_a && is_free_b) {
        // Off both lines where they cross, half off each where they are parallel.
        constexpr double soft = 1e-6;
        const Eigen::Matrix2d inverse = Eigen::Matrix2d{{1.0 + soft, cosine}, {cosine, 1.0 + soft}}.inverse();
        const Eigen::Vector2d off_both = inverse * along;
        Eigen::Matrix<double, 2, 12> change = along_by;
        change.row(0) -= off_both[1] * cosine_by;
        change.row(1) -= off_both[0] * cosine_by;
        off = result.crossing * off_both + (1.0 - result.crossing) * 0.5 * along;
        off_by = result.crossing * inverse * change + (1.0 - result.crossing) * 0.5 * along_by +
                 (off_both - 0.5 * along) * result.crossing_by.transpose();
    }
    result.offset -= off[0] * of_a.direction + off[1] * of_b.direction;
    result.offset_by -= of_a.direction * off_by.row(0) + off[0] * of_a.direction_by +
                        of_b.direction * off_by.row(1) + off[1] * of_b.direction_by;
    if (is_free_a) {
        result.s -= off[0] / of_a.length;
        result.s_by -= (off_by.row(0) - off[0] / of_a.length * of_a.length_by).transpose() / of_a.length;
    }
    if (is_free_b) {
        result.t += off[1] / of_b.length;
        result.t_by += (off_by.row(1) - off[1] / of_b.length * of_b.length_by).transpose() / of_b.length;
    }
    return result;
}

}  // namespace gxrod
