#include "constraints/joints/jet.hpp"

#include "rotation/cross_products.hpp"

namespace gxrod {

VectorJet compute_carried(const NodeMotion& motion, const Vec3& u) {
    VectorJet carried;
    carried.value = motion.Lambda * u;
    carried.rate = motion.omega.cross(carried.value);
    carried.acceleration = motion.alpha.cross(carried.value) + motion.omega.cross(carried.rate);
    return carried;
}

Jet<Mat3> differentiate_carried(const VectorJet& carried,
                                const NodeMotion& motion,
                                const NodeLinearization& linearization) {
    const Mat3 minus_value = -cross_matrix(carried.value);
    Jet<Mat3> derivative;
    derivative.value = linearization.placement * minus_value;
    derivative.rate = minus_value * linearization.d_omega + cross_columns(motion.omega, derivative.value);
    derivative.acceleration =
        minus_value * linearization.d_alpha + cross_columns(motion.alpha, derivative.value) -
        cross_columns(carried.rate, linearization.d_omega) + cross_columns(motion.omega, derivative.rate);
    return derivative;
}

}  // namespace gxrod
