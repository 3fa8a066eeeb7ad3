#include "loads/nodal_load.hpp"

#include "rotation/rotation_map.hpp"

namespace gxrod {

Vec6 evaluate_load(const NodalLoad& load, double time) {
    Vec6 value;
    for (int i = 0; i < 3; ++i) {
        value[i] = load.force[i](time);
        value[i + 3] = load.moment[i](time);
    }
    return value;
}

Vec6 turn_load(const NodalLoad& load, const Vec6& value, const NodeMotion& motion) {
    if (load.frame == Frame::spatial) return value;
    const Quat turn = load.frame == Frame::body ? motion.Lambda * load.axes : motion.Lambda;
    Vec6 turned;
    turned << turn * value.head<3>(), turn * value.tail<3>();
    return turned;
}

Vec6 compute_load(const NodalLoad& load, const NodeMotion& motion, double time) {
    return turn_load(load, evaluate_load(load, time), motion);
}

Mat6 compute_load_tangent(const NodalLoad& load, const Vec6& value, const NodeLinearization& linearization) {
    Mat6 tangent = Mat6::Zero();
    if (load.frame == Frame::spatial) return tangent;
    tangent.topRightCorner<3, 3>() = -linearization.placement * spin(value.head<3>());
    tangent.bottomRightCorner<3, 3>() = -linearization.placement * spin(value.tail<3>());
    return tangent;
}

}  // namespace gxrod
