#include "constraints/joints/joint_reaction.hpp"

#include "rotation/cross_products.hpp"

namespace gxrod {

namespace {

// [a]× [b]×.
Mat3 cross_twice(const Vec3& a, const Vec3& b) {
    Mat3 product = b * a.transpose();
    product.diagonal().array() -= a.dot(b);
    return product;
}

}  // namespace

PairVector JointReaction::compute_force(const JointFrames& frames) const {
    const Mat3& P = moments;
    const Vec3 moment(P(1, 2) - P(2, 1), P(2, 0) - P(0, 2), P(0, 1) - P(1, 0));
    PairVector on_nodes;
    on_nodes << -force, moment - frames.arm_a.value.cross(force) - frames.separation.value.cross(carried),
        force, frames.arm_b.value.cross(force) - moment;
    return on_nodes;
}

PairMatrix JointReaction::compute_derivative(const JointFrames& frames) const {
    const Vec3& arm_a = frames.arm_a.value;
    const Vec3& arm_b = frames.arm_b.value;
    // By the spins: u × w changes by [w]× [u]× δφ_A − [u]× [w]× δφ_B.
    Mat3 turned = moments;
    turned.diagonal().array() -= moments.trace();
    PairMatrix derivative = PairMatrix::Zero();
    derivative.block<3, 3>(3, 3) = turned - bends - cross_twice(force, arm_a);
    derivative.block<3, 3>(9, 3) = bends - turned;
    derivative.block<3, 3>(3, 9) = bends - turned.transpose();
    derivative.block<3, 3>(9, 9) = turned.transpose() - bends + cross_twice(force, arm_b);
    if (pull == 0.0 && carried.isZero(0.0)) return derivative;
    // δf = κ δd − [f_A]× δφ_A.
    PairJacobian separation;
    separation << -Mat3::Identity(), cross_matrix(arm_a), Mat3::Identity(), -cross_matrix(arm_b);
    PairJacobian changed = pull * separation;
    changed.middleCols<3>(3) -= cross_matrix(carried);
    derivative.middleRows<3>(0) -= changed;
    derivative.middleRows<3>(3) += cross_matrix(carried) * separation - cross_matrix(arm_a) * changed;
    derivative.middleRows<3>(6) += changed;
    derivative.middleRows<3>(9) += cross_matrix(arm_b) * changed;
    derivative.block<3, 3>(3, 3) += cross_twice(frames.separation.value, carried);
    if (curving.isZero(0.0)) return derivative;
    // δd as A's axes see it.
    separation.middleCols<3>(3) += cross_matrix(frames.separation.value);
    derivative += separation.transpose() * curving * separation;
    return derivative;
}

}  // namespace gxrod
