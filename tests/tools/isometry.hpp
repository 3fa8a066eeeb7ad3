#pragma once

#include <Eigen/LU>

#include "state/motion.hpp"

namespace gxrod::tools {

// A rotation or reflection of space. Forces and velocities are polar vectors; moments, angular velocities and
// rotation vectors are axial and keep their sense in a mirror that turns it round for polar ones.
struct Isometry {
    Mat3 S = Mat3::Identity();  // orthogonal

    static Isometry mirror(const Vec3& normal) {
        return {Mat3::Identity() - 2.0 * normal * normal.transpose()};
    }

    Vec3 polar(const Vec3& vector) const { return S * vector; }
    Vec3 axial(const Vec3& vector) const { return S.determinant() * (S * vector); }
    Quat rotation(const Quat& Lambda) const {
        return Quat(Mat3(S * Lambda.toRotationMatrix() * S.transpose()));
    }
    Mat3 tensor(const Mat3& A) const { return S * A * S.transpose(); }
    // Of a matrix that takes stacked (polar, axial) vectors to such vectors.
    Mat6 tensor(const Mat6& A) const {
        Mat6 map = Mat6::Zero();
        map.topLeftCorner<3, 3>() = S;
        map.bottomRightCorner<3, 3>() = S.determinant() * S;
        return map * A * map.transpose();
    }
    NodeMotion motion(const NodeMotion& motion) const {
        return {polar(motion.r),
                rotation(motion.Lambda),
                axial(motion.theta),
                polar(motion.v),
                polar(motion.a),
                axial(motion.omega),
                axial(motion.alpha)};
    }
    // Of stacked forces and moments.
    template <class Stacked>
    Stacked forces(const Stacked& stacked) const {
        Stacked result;
        for (int i = 0; i < stacked.size(); i += 6) {
            result.template segment<3>(i) = polar(stacked.template segment<3>(i));
            result.template segment<3>(i + 3) = axial(stacked.template segment<3>(i + 3));
        }
        return result;
    }
};

}  // namespace gxrod::tools
