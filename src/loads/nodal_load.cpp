#include "loads/nodal_load.hpp"

#include "loads/motion_load.hpp"
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
    if (load.by_motion) value += load.by_motion.value(time, 0.0, find_point_motion(motion));
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

Mat6 compute_motion_tangent(const NodalLoad& load,
                            const NodeMotion& motion,
                            const NodeLinearization& linearization,
                            double time,
                            double length) {
    const MotionDerivative by =
        differentiate(load.by_motion, time, 0.0, find_point_motion(motion), linearization, length);
    Mat6 tangent = Mat6::Zero();
    tangent.leftCols<3>() =
        linearization.placement * by.leftCols<3>() + linearization.rate * by.middleCols<3>(3);
    if (load.by_motion.turns) {
        tangent.rightCols<3>() =
            linearization.placement * by.middleCols<3>(6) * differentiate_rotation_vector(motion.Lambda) +
            by.rightCols<3>() * linearization.d_omega;
    }
    if (load.frame == Frame::spatial) return tangent;
    const Mat3 axes = find_turn(load, motion).toRotationMatrix();
    for (const Eigen::Index row : {0, 3})
        tangent.middleRows<3>(row) = (axes * tangent.middleRows<3>(row)).eval();
    return tangent;
}

}  // namespace gxrod
