#pragma once

#include <Eigen/Core>
#include <Eigen/Geometry>

namespace gxrod {

using Vec3 = Eigen::Vector3d;
using Mat3 = Eigen::Matrix3d;
using Vec6 = Eigen::Matrix<double, 6, 1>;
using Mat6 = Eigen::Matrix<double, 6, 6>;
// Unit quaternion; the storage of every rotation in gxrod. q and −q are the same rotation.
using Quat = Eigen::Quaterniond;

}  // namespace gxrod
