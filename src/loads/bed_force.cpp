#include "loads/bed_force.hpp"

#include <algorithm>
#include <cmath>

#include "rotation/rotation_map.hpp"

// Equation numbers: docs/theory/surroundings.md.
namespace gxrod {
namespace {

// Along the normal, (S12), and its derivatives by depth and by the speed inwards.
struct Press {
    GroundAt ground{};
    bool touches = false;
    double force = 0.0;
    double by_depth = 0.0, by_speed = 0.0;
};

Press compute_press(const Seabed& seabed, const BedPoint& point, const NodeMotion& motion) {
    Press press;
    press.ground = find_ground(seabed, motion.r);
    const double depth = point.radius - press.ground.gap;
    press.touches = depth > 0.0;
    if (!press.touches) return press;
    const double elastic = point.area * seabed.stiffness * depth;
    const double damped = -point.area * seabed.damping * press.ground.normal.dot(motion.v);
    press.force = elastic + std::clamp(damped, -elastic, elastic);
    const bool is_free = std::abs(damped) < elastic;
    press.by_speed = is_free ? point.area * seabed.damping : 0.0;
    press.by_depth = point.area * seabed.stiffness * (is_free ? 1.0 : damped > 0.0 ? 2.0 : 0.0);
    return press;
}

// The trial of friction is −stiffness (along P + by_axis w ⊗ w) x, P the projector into the ground's plane,
// w = P axis, x the place from the target. It slips where √(square t·t + axis_square (t·w)²) is beyond the
// force along the normal.
struct FrictionRule {
    double stiffness = 0.0;  // 0 without friction
    double along = 1.0, by_axis = 0.0;
    double square = 0.0, axis_square = 0.0;
};

// In a direction whose coefficient is zero there is no trial either. Bodies have w = 0.
FrictionRule find_friction_rule(const Seabed& seabed, const BedPoint& point) {
    const auto inverse_square = [](double coefficient) { return 1.0 / (coefficient * coefficient); };
    FrictionRule rule;
    const bool along = seabed.axial_friction > 0.0;
    const bool across = seabed.lateral_friction > 0.0;
    if (along || across) rule.stiffness = seabed.friction_stiffness * point.area;
    if (across) rule.square = inverse_square(seabed.lateral_friction);
    if (along && across) {
        rule.axis_square = inverse_square(seabed.axial_friction) - rule.square;
    } else if (along) {
        rule.along = 0.0;
        rule.by_axis = 1.0;
        rule.square = inverse_square(seabed.axial_friction);
    } else {
        rule.by_axis = -1.0;
    }
    return rule;
}

struct BedFriction {
    bool acts = false;
    FrictionRule rule{};
    Mat3 plane = Mat3::Zero();  // P
    Vec3 x = Vec3::Zero(), w = Vec3::Zero();
    Vec3 trial = Vec3::Zero();
    double size = 0.0;   // of the trial, to be compared with the force along the normal
    double share = 1.0;  // of the trial that stays; below 1 where it slips

    Vec3 force() const { return share * trial; }
};

// (S13), (S14)
BedFriction compute_friction(const Seabed& seabed,
                             const BedPoint& point,
                             const NodeMotion& motion,
                             const BedContact& before,
                             const Press& press) {
    BedFriction friction;
    friction.rule = find_friction_rule(seabed, point);
    friction.acts = before.touches && press.force > 0.0 && friction.rule.stiffness > 0.0;
    if (!friction.acts) return friction;
    const Vec3& n = press.ground.normal;
    const FrictionRule& rule = friction.rule;
    friction.plane = Mat3::Identity() - n * n.transpose();
    friction.x = motion.r - before.target;
    friction.w = friction.plane * point.axis;
    friction.trial = -rule.stiffness * (rule.along * friction.plane * friction.x +
                                        rule.by_axis * friction.w * friction.w.dot(friction.x));
    const double along = friction.trial.dot(friction.w);
    friction.size = std::sqrt(rule.square * friction.trial.squaredNorm() + rule.axis_square * along * along);
    if (friction.size > press.force) friction.share = press.force / friction.size;
    return friction;
}

// How friction follows the normal n, w and the force along the normal: each by δr, δφ or δv.
struct Changes {
    Mat3 place, normal, w;
    Eigen::RowVector3d press;
};

// (S16)
Mat3 differentiate_friction(const BedFriction& friction,
                            const Vec3& normal,
                            double press,
                            const Changes& change) {
    if (!friction.acts) return Mat3::Zero();
    const auto& [acts, rule, plane, x, w, trial, size, share] = friction;
    const Mat3 by_plane = -(normal.dot(x) * change.normal + normal * x.transpose() * change.normal);
    const Mat3 by_axis = w.dot(x) * change.w + w * (x.transpose() * change.w + w.transpose() * change.place);
    Mat3 by_trial =
        -rule.stiffness * (rule.along * (plane * change.place + by_plane) + rule.by_axis * by_axis);
    if (share == 1.0) return by_trial;
    const Eigen::RowVector3d by_size =
        (rule.square * trial.transpose() * by_trial +
         rule.axis_square * trial.dot(w) * (w.transpose() * by_trial + trial.transpose() * change.w)) /
        size;
    return share * by_trial + trial * (change.press - press / size * by_size) / size;
}

}  // namespace

BedForce compute_bed_force(const Seabed& seabed,
                           const BedPoint& point,
                           const NodeMotion& motion,
                           const BedContact& before) {
    BedForce result;
    const Press press = compute_press(seabed, point, motion);
    if (!press.touches) return result;
    const BedFriction friction = compute_friction(seabed, point, motion, before, press);
    result.pressure = press.force;
    result.force = press.force * press.ground.normal + friction.force();
    result.after.touches = true;
    // (S15)
    result.after.target = motion.r;
    if (friction.acts)
        result.after.target = friction.share < 1.0
                                  ? Vec3(motion.r - friction.share * friction.plane * friction.x)
                                  : before.target;
    return result;
}

BedForceDerivative compute_bed_force_derivative(const Seabed& seabed,
                                                const BedPoint& point,
                                                const NodeMotion& motion,
                                                const BedContact& before) {
    BedForceDerivative derivative;
    const Press press = compute_press(seabed, point, motion);
    if (press.force <= 0.0) return derivative;
    const GroundAt& ground = press.ground;
    const Vec3& n = ground.normal;
    const Mat3& turn = ground.normal_gradient;
    const BedFriction friction = compute_friction(seabed, point, motion, before, press);
    const auto differentiate = [&](const Changes& change) {
        return Mat3(n * change.press + press.force * change.normal +
                    differentiate_friction(friction, n, press.force, change));
    };
    const Mat3 w_by_place = -(n.dot(point.axis) * turn + n * point.axis.transpose() * turn);
    derivative.by_r = differentiate(
        {Mat3::Identity(),
         turn,
         w_by_place,
         -(press.by_depth * ground.gap_gradient + press.by_speed * turn.transpose() * motion.v).transpose()});
    derivative.by_phi = differentiate(
        {Mat3::Zero(), Mat3::Zero(), -friction.plane * spin(point.axis), Eigen::RowVector3d::Zero()});
    derivative.by_v =
        differentiate({Mat3::Zero(), Mat3::Zero(), Mat3::Zero(), -press.by_speed * n.transpose()});
    return derivative;
}

}  // namespace gxrod
