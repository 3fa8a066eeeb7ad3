#include "constraints/joints/joint_coordinate.hpp"

#include <cmath>
#include <complex>
#include <numbers>

namespace gxrod {

namespace {

using Complex = std::complex<double>;
using ComplexRow = Eigen::Matrix<Complex, 1, 12>;

constexpr double whole_turn = 2.0 * std::numbers::pi;

// z = x + iy.
Jet<Complex> combine(const ScalarJet& x, const ScalarJet& y) {
    return {{x.value, y.value}, {x.rate, y.rate}, {x.acceleration, y.acceleration}};
}

ComplexRow combine(const PairRow& x, const PairRow& y) {
    return x.cast<Complex>() + Complex(0.0, 1.0) * y.cast<Complex>();
}

// The direction on B whose turn is that of the joint: across the axis, of a universal joint the axis of B.
Vec3 choose_hand(const Joint& joint) { return joint.b.axes.col(joint.kind == JointKind::universal ? 0 : 1); }

}  // namespace

JointTurn::JointTurn(const Joint& joint) : axis_(joint.a.axes.col(0)) {
    const Vec3 hand = choose_hand(joint);
    x_ = LinkProduct({.on_a = hand}, {.on_b = hand});
    y_ = LinkProduct({.on_a = axis_.cross(hand)}, {.on_b = hand});
}

double JointTurn::guess(const JointMotions& motions, double turn_before) const {
    return turn_before + (motions.a.Lambda * axis_).dot(motions.b.theta - motions.a.theta);
}

ScalarJet JointTurn::compute_jet(const JointMotions& motions, double turn_before) const {
    const auto [z, z_rate, z_acceleration] = combine(x_.compute_jet(motions), y_.compute_jet(motions));
    const double within = std::arg(z);
    const double turns = std::nearbyint((guess(motions, turn_before) - within) / whole_turn);
    const Complex growth = z_rate / z;
    return {within + turns * whole_turn, growth.imag(), (z_acceleration / z - growth * growth).imag()};
}

double JointTurn::compute_branch_distance(const JointMotions& motions, double turn_before) const {
    return std::abs(compute_jet(motions, turn_before).value - guess(motions, turn_before));
}

PairRow JointTurn::compute_gradient(const JointMotions& motions) const {
    const Complex z = combine(x_.compute_jet(motions), y_.compute_jet(motions)).value;
    return (combine(x_.compute_gradient(motions), y_.compute_gradient(motions)) / z).imag();
}

PairMatrix JointTurn::compute_second_derivative(const JointMotions& motions) const {
    const Complex z = combine(x_.compute_jet(motions), y_.compute_jet(motions)).value;
    const ComplexRow growth = combine(x_.compute_gradient(motions), y_.compute_gradient(motions)) / z;
    const PairMatrix product = growth.real().transpose() * growth.imag();
    const Complex inverse = 1.0 / z;
    return inverse.imag() * x_.compute_second_derivative(motions) +
           inverse.real() * y_.compute_second_derivative(motions) - product - product.transpose();
}

Jet<PairRow> JointTurn::differentiate(const JointMotions& motions,
                                      const JointLinearizations& linearizations) const {
    const auto [z, z_rate, z_acceleration] = combine(x_.compute_jet(motions), y_.compute_jet(motions));
    const Jet<PairRow> x = x_.differentiate(motions, linearizations);
    const Jet<PairRow> y = y_.differentiate(motions, linearizations);
    const Complex growth = z_rate / z;
    const ComplexRow value = combine(x.value, y.value) / z;
    const ComplexRow rate = combine(x.rate, y.rate) / z - growth * value;
    const ComplexRow acceleration =
        combine(x.acceleration, y.acceleration) / z - z_acceleration / z * value - 2.0 * growth * rate;
    return {value.imag(), rate.imag(), acceleration.imag()};
}

LinkVector separate_points(const Joint& joint) {
    return {.on_a = -joint.a.anchor.arm, .on_b = joint.b.anchor.arm, .span = 1.0};
}

LinkProduct make_slide(const Joint& joint) { return {{.on_a = joint.a.axes.col(0)}, separate_points(joint)}; }

JointCoordinates::JointCoordinates(const Joint& joint) {
    if (joint.has_turn()) turn.emplace(joint);
    if (joint.has_slide()) slide = make_slide(joint);
}

}  // namespace gxrod
