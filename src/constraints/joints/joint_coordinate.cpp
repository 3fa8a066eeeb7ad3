#include "constraints/joints/joint_coordinate.hpp"

#include <cmath>
#include <complex>
#include <numbers>

namespace gxrod {

namespace {

using Complex = std::complex<double>;
using Kind = LinkVector::Kind;

constexpr double whole_turn = 2.0 * std::numbers::pi;

// z = x + iy.
Jet<Complex> combine(const ScalarJet& x, const ScalarJet& y) {
    return {{x.value, y.value}, {x.rate, y.rate}, {x.acceleration, y.acceleration}};
}

// The direction on B whose turn is that of the joint: across the axis, of a universal joint the axis of B.
Vec3 choose_hand(const Joint& joint) { return joint.b.axes.col(joint.kind == JointKind::universal ? 0 : 1); }

// Turns need no points.
JointFrames turn_frames(const JointMotions& motions, ConstraintLevel level) { return {motions, {}, level}; }

}  // namespace

JointArms arms_of(const Joint& joint) { return {joint.a.anchor.arm, joint.b.anchor.arm}; }

JointTurn::JointTurn(const Joint& joint)
    : axis_(joint.a.axes.col(0)), hand_(choose_hand(joint)), across_(axis_.cross(hand_)) {
    x_ = LinkProduct({Kind::on_a, hand_}, {Kind::on_b, hand_});
    y_ = LinkProduct({Kind::on_a, across_}, {Kind::on_b, hand_});
}

double JointTurn::guess(const JointMotions& motions, double turn_before) const {
    return turn_before + (motions.a.Lambda * axis_).dot(motions.b.theta - motions.a.theta);
}

ScalarJet JointTurn::compute_jet(const JointFrames& frames, double turn_before) const {
    const auto [z, z_rate, z_acceleration] = combine(x_.compute_jet(frames), y_.compute_jet(frames));
    const double within = std::arg(z);
    const double turns = std::nearbyint((guess(frames.motions, turn_before) - within) / whole_turn);
    const Complex growth = z_rate / z;
    return {within + turns * whole_turn, growth.imag(), (z_acceleration / z - growth * growth).imag()};
}

ScalarJet JointTurn::compute_jet(const JointMotions& motions, double turn_before) const {
    return compute_jet(turn_frames(motions, ConstraintLevel::acceleration), turn_before);
}

double JointTurn::compute_branch_distance(const JointMotions& motions, double turn_before) const {
    return std::abs(compute_jet(motions, turn_before).value - guess(motions, turn_before));
}

PairRow JointTurn::compute_gradient(const JointMotions& motions) const {
    PairRow gradient = PairRow::Zero();
    add_gradient(turn_frames(motions, ConstraintLevel::position), 1.0, gradient);
    return gradient;
}

JointTurn::Place JointTurn::find_place(const JointFrames& frames) const {
    const Vec3 w = frames.R_b * hand_, e1 = frames.R_a * hand_, e2 = frames.R_a * across_;
    const double x = w.dot(e1), y = w.dot(e2), square = x * x + y * y;
    return {(x * e2 - y * e1) / square, (x * e1 + y * e2) / square, w};
}

void JointTurn::add_gradient(const JointFrames& frames, double factor, PairRow& row) const {
    const auto [u, v, w] = find_place(frames);
    const Vec3 moment = factor * u.cross(w);
    row.segment<3>(3) += moment;
    row.segment<3>(9) -= moment;
}

void JointTurn::add_change(const JointFrames& frames,
                           const JointLinearizations& linearizations,
                           const ScalarJet& weights,
                           PairRow& row) const {
    const auto [z, z_rate, z_acceleration] = combine(x_.compute_jet(frames), y_.compute_jet(frames));
    const Complex inverse = 1.0 / z;
    const Complex growth = z_rate * inverse;
    const Complex curvature = 2.0 * growth * growth - z_acceleration * inverse;
    // δz, δż and δz̈ are multiplied by these.
    const Complex of_acceleration = weights.acceleration * inverse;
    const Complex of_rate = (weights.rate - 2.0 * weights.acceleration * growth) * inverse;
    const Complex of_value =
        (weights.value - weights.rate * growth + weights.acceleration * curvature) * inverse;
    x_.add_change(frames, linearizations, {of_value.imag(), of_rate.imag(), of_acceleration.imag()}, row);
    y_.add_change(frames, linearizations, {of_value.real(), of_rate.real(), of_acceleration.real()}, row);
}

void JointTurn::add_reaction(const JointFrames& frames, double multiplier, JointReaction& reaction) const {
    const auto [u, v, w] = find_place(frames);
    reaction.moments += multiplier * u * w.transpose();
    const Mat3 bend = multiplier * u.cross(w) * v.cross(w).transpose();
    reaction.bends += bend + bend.transpose();
}

JointSlide::JointSlide(const Joint& joint)
    : arms_(arms_of(joint)), product_({Kind::on_a, joint.a.axes.col(0)}, {Kind::separation}) {}

ScalarJet JointSlide::compute_jet(const JointMotions& motions) const {
    return product_.compute_jet({motions, arms_, ConstraintLevel::acceleration});
}

PairRow JointSlide::compute_gradient(const JointMotions& motions) const {
    PairRow gradient = PairRow::Zero();
    product_.add_gradient({motions, arms_, ConstraintLevel::position}, 1.0, gradient);
    return gradient;
}

JointCoordinates::JointCoordinates(const Joint& joint) {
    if (joint.has_turn()) turn.emplace(joint);
    if (joint.has_slide()) slide.emplace(joint);
}

}  // namespace gxrod
