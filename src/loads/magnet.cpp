#include "loads/magnet.hpp"

#include "rotation/rotation_map.hpp"

namespace gxrod {
namespace {

// Of a length over which the field changes by its own size, differences over this part of it on seven points
// have an error of some 1e-12.
constexpr double step_share = 0.02;
// Second differences, of which only tangents are made: some 1e-6.
constexpr double second_step_share = 0.002;

Vec3 field_near(const Magnet& magnet, const Vec3& offset) {
    return magnet.field.at(magnet.time, magnet.position + offset);
}

// Columns are the derivatives of B by x, y and z.
Mat3 compute_gradient(const Magnet& magnet) {
    Mat3 gradient = Mat3::Zero();
    if (!magnet.field.by_place) return gradient;
    const double step = step_share * magnet.length;
    for (int i = 0; i < 3; ++i) {
        const auto differ = [&](double steps) {
            const Vec3 offset = steps * step * Vec3::Unit(i);
            return Vec3(field_near(magnet, offset) - field_near(magnet, -offset));
        };
        gradient.col(i) = (45.0 * differ(1.0) - 9.0 * differ(2.0) + differ(3.0)) / (60.0 * step);
    }
    return gradient;
}

// The second derivative of μ · B by the position.
Mat3 compute_hessian(const Magnet& magnet) {
    Mat3 hessian = Mat3::Zero();
    if (!magnet.field.by_place) return hessian;
    const double step = second_step_share * magnet.length;
    const auto at = [&](const Vec3& offset) { return magnet.moment.dot(field_near(magnet, offset)); };
    for (int i = 0; i < 3; ++i) {
        for (int j = 0; j <= i; ++j) {
            const Vec3 a = step * Vec3::Unit(i);
            const Vec3 b = step * Vec3::Unit(j);
            hessian(i, j) = (at(a + b) - at(a - b) - at(b - a) + at(-a - b)) / (4.0 * step * step);
            hessian(j, i) = hessian(i, j);
        }
    }
    return hessian;
}

}  // namespace

Vec6 compute_magnetic_load(const Magnet& magnet) {
    Vec6 load;
    load << compute_gradient(magnet).transpose() * magnet.moment,
        magnet.moment.cross(field_near(magnet, Vec3::Zero()));
    return load;
}

Mat6 compute_magnetic_tangent(const Magnet& magnet) {
    const Mat3 turned = spin(magnet.moment);
    const Mat3 gradient = compute_gradient(magnet);
    Mat6 tangent;
    tangent.topLeftCorner<3, 3>() = compute_hessian(magnet);
    tangent.topRightCorner<3, 3>() = -gradient.transpose() * turned;
    tangent.bottomLeftCorner<3, 3>() = turned * gradient;
    tangent.bottomRightCorner<3, 3>() = spin(field_near(magnet, Vec3::Zero())) * turned;
    return tangent;
}

}  // namespace gxrod
