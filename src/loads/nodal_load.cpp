#include "loads/nodal_load.hpp"

#include <algorithm>
#include <cmath>

#include "rotation/rotation_map.hpp"

namespace gxrod {
namespace {

// The axes in which a load that turns with its node is given.
Quat find_turn(const NodalLoad& load, const NodeMotion& motion) {
    return load.frame == Frame::body ? motion.Lambda * load.axes : motion.Lambda;
}

}  // namespace

Vec6 evaluate_load(const NodalLoad& load, double time) {
    Vec6 value;
    for (int i = 0; i < 3; ++i) {
        value[i] = load.force[i](time);
        value[i + 3] = load.moment[i](time);
    }
    return value;
}

Vec6 compute_load(const NodalLoad& load, const Vec6& at_time, const NodeMotion& motion, double time) {
    Vec6 value = at_time;
    if (load.motion_force) value.head<3>() += load.motion_force(time, motion.r, motion.v);
    if (load.frame == Frame::spatial) return value;
    const Quat turn = find_turn(load, motion);
    value << turn * value.head<3>().eval(), turn * value.tail<3>().eval();
    return value;
}

Vec6 compute_load(const NodalLoad& load, const NodeMotion& motion, double time) {
    return compute_load(load, evaluate_load(load, time), motion, time);
}

Mat6 compute_load_tangent(const NodalLoad& load, const Vec6& value, const NodeLinearization& linearization) {
    Mat6 tangent = Mat6::Zero();
    if (load.frame == Frame::spatial) return tangent;
    tangent.topRightCorner<3, 3>() = -linearization.placement * spin(value.head<3>());
    tangent.bottomRightCorner<3, 3>() = -linearization.placement * spin(value.tail<3>());
    return tangent;
}

// By central differences. On a kink, the mean of both sides.
Mat3 compute_motion_force_tangent(const NodalLoad& load,
                                  const NodeMotion& motion,
                                  const NodeLinearization& linearization,
                                  double time,
                                  double length) {
    // The cube root of a double's round-off, where that of the difference and its truncation are about equal.
    constexpr double share = 6e-6;
    constexpr double share_at_rest = 0.1;
    const double step = share * std::max(motion.r.norm(), length);
    const double speed = share_at_rest * std::abs(linearization.rate) * length;
    const double step_of_v = share * std::max(motion.v.norm(), speed);
    Mat3 tangent = Mat3::Zero();
    for (int i = 0; i < 3; ++i) {
        const Vec3 along = Vec3::Unit(i);
        const auto differ = [&](double moved, double sped) {
            const Vec3 r = moved * along;
            const Vec3 v = sped * along;
            return Vec3(load.motion_force(time, motion.r + r, motion.v + v) -
                        load.motion_force(time, motion.r - r, motion.v - v));
        };
        if (linearization.placement != 0.0)
            tangent.col(i) += linearization.placement / (2.0 * step) * differ(step, 0.0);
        if (linearization.rate != 0.0)
            tangent.col(i) += linearization.rate / (2.0 * step_of_v) * differ(0.0, step_of_v);
    }
    return load.frame == Frame::spatial ? tangent : Mat3(find_turn(load, motion) * tangent);
}

}  // namespace gxrod
