#include "contact/pairs/pair_friction.hpp"

#include <algorithm>

#include "rotation/rotation_map.hpp"
#include "rotation/tangent_map.hpp"

namespace gxrod {

namespace {

using Row12 = Eigen::Matrix<double, 1, 12>;
using Mat312 = Eigen::Matrix<double, 3, 12>;

// The shares of the ends in d, and in Ω.
struct Shares {
    double of_distance[4], of_rotation[4];

    Shares(const PairPlace& at, const PairMotion& motion) {
        const double a = motion.radius_a / (motion.radius_a + motion.radius_b), b = 1.0 - a;
        const double of_lines[4] = {1.0 - at.s, at.s, 1.0 - at.t, at.t};
        for (int i = 0; i < 4; ++i) {
            of_distance[i] = (i < 2 ? 1.0 : -1.0) * of_lines[i];
            of_rotation[i] = (i < 2 ? a : b) * of_lines[i];
        }
    }
};

Vec3 sum(const double (&shares)[4], const std::array<Vec3, 4>& of_ends) {
    return shares[0] * of_ends[0] + shares[1] * of_ends[1] + shares[2] * of_ends[2] + shares[3] * of_ends[3];
}

// The friction with its axes along the parts, where they have one: the second is reversed.
CoulombFriction with_axes(const PairMotion& motion, CoulombFriction friction) {
    if (friction.shape == nullptr) return friction;
    const auto& x = motion.positions;
    if (!friction.axes[0].isZero(0.0)) friction.axes[0] = (x[1] - x[0]).normalized();
    if (!friction.axes[1].isZero(0.0)) friction.axes[1] = (x[2] - x[3]).normalized();
    return friction;
}

// What the traction follows from.
struct Slipping {
    Vec3 distance, distance_before, rotation;
    Mat3 turn;
    Vec3 pull;
    CoulombFriction friction;  // with the traction before, turned with the rods

    Slipping(const PairPlace& at, const PairMotion& motion, const CoulombFriction& given)
        : friction(with_axes(motion, given)) {
        const Shares shares(at, motion);
        distance = sum(shares.of_distance, motion.positions);
        distance_before = sum(shares.of_distance, motion.positions_before);
        rotation = sum(shares.of_rotation, motion.rotations);
        turn = exp_matrix(rotation);
        pull = turn * (given.traction + given.stiffness * distance_before) - given.stiffness * distance;
        friction.traction = turn * given.traction;
    }
};

// Adds the derivatives of the traction by positions through the axes.
void add_by_axes(const TractionDerivative& there,
                 const CoulombFriction& friction,
                 const PairMotion& motion,
                 Mat312& traction_by) {
    for (std::size_t i = 0; i < 2; ++i) {
        const Vec3& axis = friction.axes[i];
        if (axis.isZero(0.0)) continue;
        const double length = (motion.positions[2 * i + 1] - motion.positions[2 * i]).norm();
        const double sign = i == 0 ? 1.0 : -1.0;
        const Mat3 by_end = sign / length * there.by_axes[i] * (Mat3::Identity() - axis * axis.transpose());
        const auto column = static_cast<Eigen::Index>(6 * i);
        traction_by.middleCols<3>(column) -= by_end;
        traction_by.middleCols<3>(column + 3) += by_end;
    }
}

}  // namespace

PairPlace find_pair_place(const PairEnergy& energy, const PairMotion& motion) {
    PairPlace at;
    const Vec12& g = energy.gradient;
    const Vec3 force = energy.force();
    at.force = force.norm();
    if (at.force > 0.0) {
        at.normal = force / at.force;
        at.s = std::clamp(-g.segment<3>(3).dot(at.normal) / at.force, 0.0, 1.0);
        at.t = std::clamp(g.segment<3>(9).dot(at.normal) / at.force, 0.0, 1.0);
        return at;
    }
    const ClosestPoints closest = find_closest_points({motion.positions[0], motion.positions[1]},
                                                      {motion.positions[2], motion.positions[3]});
    at.s = closest.s;
    at.t = closest.t;
    at.normal = closest.offset / closest.distance;
    return at;
}

PairFriction compute_pair_friction(const PairEnergy& energy,
                                   const PairMotion& motion,
                                   const CoulombFriction& friction) {
    PairFriction result;
    const PairPlace at = find_pair_place(energy, motion);
    if (!friction.acts(at.force)) return result;
    const Slipping slipping(at, motion, friction);
    result.traction = compute_traction(slipping.pull, at.normal, at.force, slipping.friction);
    result.traction_before = slipping.friction.traction;
    result.slip = slipping.distance - slipping.turn * slipping.distance_before;
    const Shares shares(at, motion);
    const Vec3 moment = -slipping.distance.cross(result.traction.value);
    for (int i = 0; i < 4; ++i) {
        result.forces.segment<3>(6 * i) = shares.of_distance[i] * result.traction.value;
        result.forces.segment<3>(6 * i + 3) = shares.of_rotation[i] * moment;
    }
    return result;
}

Mat24 compute_pair_friction_derivative(const PairEnergy& energy,
                                       const PairMotion& motion,
                                       const CoulombFriction& friction) {
    Mat24 result = Mat24::Zero();
    const PairPlace at = find_pair_place(energy, motion);
    if (!friction.acts(at.force)) return result;
    const Slipping slipping(at, motion, friction);
    const Shares shares(at, motion);
    const double ratio_a = motion.radius_a / (motion.radius_a + motion.radius_b), ratio_b = 1.0 - ratio_a;
    const double k = friction.stiffness;
    const Mat12& H = energy.hessian;
    // The normal force, its direction and its place, by positions.
    const Mat312 force_by = -(H.middleRows<3>(0) + H.middleRows<3>(3));
    const Row12 size_by = at.normal.transpose() * force_by;
    const Mat312 normal_by = (force_by - at.normal * size_by) / at.force;
    const auto place_by = [&](int row, double sign, double place) -> Row12 {
        if (place <= 0.0 || place >= 1.0) return Row12::Zero();
        return (sign * (at.normal.transpose() * H.middleRows<3>(row) +
                        energy.gradient.segment<3>(row).transpose() * normal_by) -
                place * size_by) /
               at.force;
    };
    const Row12 s_by = place_by(3, -1.0, at.s), t_by = place_by(9, 1.0, at.t);
    const auto along = [&](const std::array<Vec3, 4>& of_ends, double a, double b) -> Mat312 {
        return a * (of_ends[1] - of_ends[0]) * s_by + b * (of_ends[3] - of_ends[2]) * t_by;
    };
    Mat312 distance_by = along(motion.positions, 1.0, -1.0);
    for (int i = 0; i < 4; ++i) distance_by.middleCols<3>(3 * i).diagonal().array() += shares.of_distance[i];
    const Mat3 pull_by_rotation = -spin(slipping.turn * (friction.traction + k * slipping.distance_before)) *
                                  tangent_map(slipping.rotation);
    const TractionDerivative there =
        compute_traction_derivative(slipping.pull, at.normal, at.force, slipping.friction);
    const Vec3 t = compute_traction(slipping.pull, at.normal, at.force, slipping.friction).value;
    Mat312 traction_by =
        there.by_pull * (k * slipping.turn * along(motion.positions_before, 1.0, -1.0) - k * distance_by +
                         pull_by_rotation * along(motion.rotations, ratio_a, ratio_b)) +
        there.by_normal * normal_by + there.by_force * size_by;
    Mat3 traction_by_rotation = there.by_pull * pull_by_rotation;
    if (friction.shape != nullptr) {
        const Mat3 by_turning =
            -there.by_traction * spin(slipping.friction.traction) * tangent_map(slipping.rotation);
        traction_by_rotation += by_turning;
        traction_by += by_turning * along(motion.rotations, ratio_a, ratio_b);
        add_by_axes(there, slipping.friction, motion, traction_by);
    }
    const Mat3 arm = spin(slipping.distance);
    const Vec3 moment = -arm * t;
    const Mat312 moment_by = spin(t) * distance_by - arm * traction_by;
    const Row12 shares_by[4] = {-s_by, s_by, -t_by, t_by};
    for (int i = 0; i < 4; ++i) {
        const double sign = i < 2 ? 1.0 : -1.0, ratio = i < 2 ? ratio_a : ratio_b;
        const Mat312 force = shares.of_distance[i] * traction_by + sign * t * shares_by[i];
        const Mat312 moments = shares.of_rotation[i] * moment_by + ratio * moment * shares_by[i];
        for (int j = 0; j < 4; ++j) {
            result.block<3, 3>(6 * i, 6 * j) = force.middleCols<3>(3 * j);
            result.block<3, 3>(6 * i + 3, 6 * j) = moments.middleCols<3>(3 * j);
            result.block<3, 3>(6 * i, 6 * j + 3) =
                shares.of_distance[i] * shares.of_rotation[j] * traction_by_rotation;
            result.block<3, 3>(6 * i + 3, 6 * j + 3) =
                -shares.of_rotation[i] * shares.of_rotation[j] * arm * traction_by_rotation;
        }
    }
    return result;
}

CoulombFriction advance_pair_slip(const PairEnergy& energy,
                                  const PairMotion& motion,
                                  const PairIncrement& increment,
                                  const CoulombFriction& friction) {
    const PairPlace at = find_pair_place(energy, motion);
    PairMotion moved = motion;
    Vec12 move;
    for (std::size_t i = 0; i < 4; ++i) {
        moved.positions[i] += increment.displacements[i];
        moved.rotations[i] += increment.turns[i];
        move.segment<3>(3 * static_cast<Eigen::Index>(i)) = increment.displacements[i];
    }
    const Vec3 change = -(energy.hessian.middleRows<3>(0) + energy.hessian.middleRows<3>(3)) * move;
    const Slipping slipping(at, moved, friction);
    CoulombFriction decided = decide_slip(
        slipping.pull, at.normal, at.force > 0.0 ? at.force + at.normal.dot(change) : 0.0, slipping.friction);
    decided.traction = friction.traction;
    return decided;
}

}  // namespace gxrod
