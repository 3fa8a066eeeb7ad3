#include "contact/pairs/pair_impulse.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace gxrod {
namespace {

// The parts n · G of the forces on four ends along the normal, and their derivatives.
struct NormalParts {
    double values[4];
    Row12 by[4];

    NormalParts(const PairEnergy& pair, const Vec3& n, const Mat312& n_by) {
        for (int end = 0; end < 4; ++end) {
            const auto G = pair.gradient.segment<3>(3 * end);
            values[end] = n.dot(G);
            by[end] = n.transpose() * pair.hessian.middleRows<3>(3 * end) + G.transpose() * n_by;
        }
    }
    // Takes the force on the segment whose first end this is back by half of what its place has moved, in
    // parts of the length.
    void take_back(int end, double moved, const Vec12& moved_by, const OpenContact& contact) {
        constexpr double most = 1.5;
        const double half = std::clamp(0.5 * moved, -most, most), part = half * contact.crossing;
        const double sum = values[end] + values[end + 1];
        Row12 change = part * (by[end] + by[end + 1]) + half * sum * contact.crossing_by.transpose();
        if (std::abs(half) < most) change += 0.5 * contact.crossing * sum * moved_by.transpose();
        values[end] += part * sum;
        values[end + 1] -= part * sum;
        by[end] += change;
        by[end + 1] -= change;
    }
};

// A direction, by the ends of segments.
struct Direction {
    Vec3 value;
    Mat312 by;
};

// (C18), of normals at the start and at the end.
Direction find_mean(const Vec3& before, const Direction& n) {
    const double cosine = before.dot(n.value);
    if (cosine <= 0.0) return {n.value + before, n.by};
    const Vec3 mean = (n.value + before) / (1.0 + cosine);
    return {mean, (n.by - mean * (before.transpose() * n.by)) / (1.0 + cosine)};
}

// (C21): lessens the work of forces with these parts along a direction to that of the change of the distance,
// by what they get along the way of the places where they act.
void take_gain(const NormalParts& parts,
               const Vec12& way,
               double change,
               const Vec12& change_by,
               double radii,
               Direction& direction) {
    constexpr double shortest = 1e-3, most = 0.9;
    const double sum = parts.values[0] + parts.values[1];
    if (sum == 0.0) return;
    Vec3 moved = Vec3::Zero();
    Mat312 moved_by = Mat312::Zero();
    for (int end = 0; end < 4; ++end) {
        moved += parts.values[end] * way.segment<3>(3 * end);
        moved_by += way.segment<3>(3 * end) * parts.by[end];
        moved_by.middleCols<3>(3 * end).diagonal().array() += parts.values[end];
    }
    moved /= sum;
    moved_by = (moved_by - moved * (parts.by[0] + parts.by[1])) / sum;
    const double square = moved.squaredNorm() + shortest * radii * shortest * radii;
    const double lack = (change - direction.value.dot(moved)) / square, length = moved.norm();
    if (lack >= 0.0) return;
    if (-lack * length < most) {
        const Vec12 lack_by = (change_by - direction.by.transpose() * moved -
                               moved_by.transpose() * (direction.value + 2.0 * lack * moved)) /
                              square;
        direction.value += lack * moved;
        direction.by += moved * lack_by.transpose() + lack * moved_by;
    } else {
        direction.value -= most / length * moved;
        direction.by -=
            most / length * (moved_by - moved * (moved.transpose() * moved_by) / (length * length));
    }
}

}  // namespace

Vec12 find_ends(const Segment& a, const Segment& b) {
    Vec12 ends;
    ends << a.start, a.end, b.start, b.end;
    return ends;
}

void turn_impulse(const Segment& a,
                  const Segment& b,
                  const OpenEnds& open,
                  const PairStart& start,
                  double radii,
                  PairEnergy& pair) {
    const OpenContact contact = find_open_contact(a, b, open);
    const double length = contact.offset.norm();
    Direction n{contact.offset / length, {}};
    n.by = (Mat3::Identity() - n.value * n.value.transpose()) / length * contact.offset_by;
    const NormalParts at_end(pair, n.value, n.by);
    NormalParts parts = at_end;
    parts.take_back(0, contact.s - start.s, contact.s_by, contact);
    parts.take_back(2, contact.t - start.t, contact.t_by, contact);
    Direction mean = find_mean(start.offset.normalized(), n);
    const ClosestPoints& inside = contact.inside;
    const double shares[4] = {1.0 - inside.s, inside.s, inside.t - 1.0, -inside.t};
    Vec12 change_by;
    for (int end = 0; end < 4; ++end)
        change_by.segment<3>(3 * end) = shares[end] / inside.distance * inside.offset;
    take_gain(parts, find_ends(a, b) - start.ends, inside.distance - start.distance, change_by, radii, mean);
    for (int end = 0; end < 4; ++end) {
        pair.hessian.middleRows<3>(3 * end) += mean.value * parts.by[end] + parts.values[end] * mean.by -
                                               n.value * at_end.by[end] - at_end.values[end] * n.by;
        pair.gradient.segment<3>(3 * end) += parts.values[end] * mean.value - at_end.values[end] * n.value;
    }
}

namespace {

std::array<double, 4> find_shares(const PairStart& start) {
    const double s = std::clamp(start.s, 0.0, 1.0), t = std::clamp(start.t, 0.0, 1.0);
    return {1.0 - s, s, t - 1.0, -t};
}

}  // namespace

Vec3 find_relative_way(const PairStart& start, const Vec12& way) {
    const std::array<double, 4> shares = find_shares(start);
    Vec3 sum = Vec3::Zero();
    for (int end = 0; end < 4; ++end) sum += shares[static_cast<std::size_t>(end)] * way.segment<3>(3 * end);
    return sum;
}

void add_drag(PairEnergy& pair, const PairStart& start, const Vec12& way, double drag) {
    const std::array<double, 4> shares = find_shares(start);
    const Vec3 force = drag * find_relative_way(start, way);
    for (int i = 0; i < 4; ++i) {
        const double own = shares[static_cast<std::size_t>(i)];
        pair.gradient.segment<3>(3 * i) += own * force;
        for (int j = 0; j < 4; ++j)
            pair.hessian.block<3, 3>(3 * i, 3 * j).diagonal().array() +=
                drag * own * shares[static_cast<std::size_t>(j)];
    }
}

namespace {

// The factor of damping, and its derivatives by the ends for a fixed motion, and by the motion.
struct DampingFactor {
    double value = 1.0;
    Vec12 by_ends = Vec12::Zero();
    double by_motion = 0.0;  // times G
};

DampingFactor find_damping(const PairEnergy& pair, const Vec12& motion, double damping) {
    DampingFactor factor;
    const Vec3 force = pair.force();
    const double size = force.norm();
    if (size == 0.0) return factor;
    const double work = pair.gradient.dot(motion);
    factor.value = std::max(1.0 + damping * work / size, 0.0);
    if (factor.value == 0.0) return factor;
    const Vec12 size_by =
        -(pair.hessian.middleRows<3>(0) + pair.hessian.middleRows<3>(3)).transpose() * force / size;
    factor.by_ends = (damping / size) * (pair.hessian.transpose() * motion - (work / size) * size_by);
    factor.by_motion = damping / size;
    return factor;
}

}  // namespace

double damp_by_rates(PairEnergy& pair, const Vec12& rates, double damping) {
    const DampingFactor factor = find_damping(pair, rates, damping);
    pair.hessian = (factor.value * pair.hessian + pair.gradient * factor.by_ends.transpose()).eval();
    pair.gradient *= factor.value;
    return factor.value > 0.0 ? factor.by_motion / (factor.value * factor.value) : 0.0;
}

void damp(PairEnergy& pair, const Vec12& motion, double damping) {
    const Vec3 force = pair.force();
    const double size = force.norm();
    if (size == 0.0) return;
    const double work = pair.gradient.dot(motion);
    const double factor = 1.0 + damping * work / size;
    if (factor <= 0.0) {
        pair.gradient.setZero();
        pair.hessian.setZero();
        return;
    }
    const Vec12 size_by =
        -(pair.hessian.middleRows<3>(0) + pair.hessian.middleRows<3>(3)).transpose() * force / size;
    const Vec12 factor_by =
        (damping / size) * (pair.hessian.transpose() * motion + pair.gradient - (work / size) * size_by);
    pair.hessian = (factor * pair.hessian + pair.gradient * factor_by.transpose()).eval();
    pair.gradient *= factor;
}

}  // namespace gxrod
