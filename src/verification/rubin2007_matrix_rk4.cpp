#include "verification/rubin2007_matrix_rk4.hpp"

#include <Eigen/LU>

#include "rotation/rotation_map.hpp"
#include "verification/rubin2007_problem.hpp"

namespace gxrod::rubin2007 {

namespace {

Mat3 compute_inertia(const Mat3& Lambda) {
    return Lambda * Vec3(inertia_1, inertia_1, inertia_3).asDiagonal() * Lambda.transpose();
}

MatrixMotion compute_rate(const MatrixMotion& motion, double time) {
    const Mat3 J = compute_inertia(motion.Lambda);
    const Vec3 torque = moment(time) - motion.omega.cross(J * motion.omega);
    return {spin(motion.omega) * motion.Lambda, J.inverse() * torque};
}

MatrixMotion add(const MatrixMotion& motion, double factor, const MatrixMotion& rate) {
    return {motion.Lambda + factor * rate.Lambda, motion.omega + factor * rate.omega};
}

}  // namespace

MatrixMotion step_matrix_rk4(const MatrixMotion& motion, double time, double time_step) {
    const MatrixMotion k1 = compute_rate(motion, time);
    const MatrixMotion k2 = compute_rate(add(motion, 0.5 * time_step, k1), time + 0.5 * time_step);
    const MatrixMotion k3 = compute_rate(add(motion, 0.5 * time_step, k2), time + 0.5 * time_step);
    const MatrixMotion k4 = compute_rate(add(motion, time_step, k3), time + time_step);
    return {motion.Lambda + time_step / 6.0 * (k1.Lambda + 2.0 * k2.Lambda + 2.0 * k3.Lambda + k4.Lambda),
            motion.omega + time_step / 6.0 * (k1.omega + 2.0 * k2.omega + 2.0 * k3.omega + k4.omega)};
}

Vec3 compute_momentum(const MatrixMotion& motion) { return compute_inertia(motion.Lambda) * motion.omega; }

}  // namespace gxrod::rubin2007
