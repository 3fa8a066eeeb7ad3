#include "constraints/joints/joint_rows.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace gxrod {

namespace {

// An axis of A's, or of B's, as the node carries it.
LinkVector carry_on_a(const Joint& joint, int axis) { return {.on_a = joint.a.axes.col(axis)}; }
LinkVector carry_on_b(const Joint& joint, int axis) { return {.on_b = joint.b.axes.col(axis)}; }

// Whether a joint's point is its node, or a fixed one.
bool is_at_node(const Anchor& anchor) { return anchor.is_ground() || anchor.arm.isZero(0.0); }

double at_level(const ScalarJet& jet, ConstraintLevel level) {
    switch (level) {
        case ConstraintLevel::position:
            return jet.value;
        case ConstraintLevel::velocity:
            return jet.rate;
        default:
            return jet.acceleration;
    }
}

}  // namespace

JointRows::JointRows(const Joint& joint) : coordinates_(joint) {
    is_linear_ = (joint.kind == JointKind::ball || joint.kind == JointKind::weld) &&
                 is_at_node(joint.a.anchor) && is_at_node(joint.b.anchor);
    add_kind(joint);
    add_motors(joint);
}

void JointRows::add_kind(const Joint& joint) {
    const LinkVector separation = separate_points(joint);
    switch (joint.kind) {
        case JointKind::ball:
            return add_points(separation);
        case JointKind::hinge:
            add_points(separation);
            return add_aligned_axes(joint);
        case JointKind::cylinder:
            add_across(joint, separation);
            return add_aligned_axes(joint);
        case JointKind::slider:
            add_across(joint, separation);
            return add_equal_axes(joint);
        case JointKind::universal:
            add_points(separation);
            return add({.product = {carry_on_a(joint, 0), carry_on_b(joint, 0)}});
        case JointKind::screw:
            add_across(joint, separation);
            add_aligned_axes(joint);
            return add({.is_length = true,
                        .product = *coordinates_.slide,
                        .turn_factor = -0.5 * joint.lead / std::numbers::pi});
        case JointKind::plane:
            add({.is_length = true, .product = {carry_on_a(joint, 0), separation}});
            return add_aligned_axes(joint);
        case JointKind::weld:
            add_points(separation);
            return add_equal_axes(joint);
        case JointKind::distance:
            return add_distance(joint.length, separation);
    }
}

// Both points coincide.
void JointRows::add_points(const LinkVector& separation) {
    for (int i = 0; i < 3; ++i)
        add({.is_length = true, .product = {{.in_space = Vec3::Unit(i)}, separation}});
}

// A's axis is across the other two of B.
void JointRows::add_aligned_axes(const Joint& joint) {
    for (const int across : {1, 2}) add({.product = {carry_on_a(joint, 0), carry_on_b(joint, across)}});
}

// A does not turn against B.
void JointRows::add_equal_axes(const Joint& joint) {
    for (int i = 0; i < 3; ++i) add({.product = {carry_on_a(joint, i), carry_on_b(joint, (i + 1) % 3)}});
}

// B's point is on A's axis.
void JointRows::add_across(const Joint& joint, const LinkVector& separation) {
    for (const int across : {1, 2})
        add({.is_length = true, .product = {carry_on_a(joint, across), separation}});
}

void JointRows::add_distance(double length, const LinkVector& separation) {
    add({.is_length = true,
         .factor = 0.5 / length,
         .product = {separation, separation},
         .constant = -0.5 * length});
}

void JointRows::add_motors(const Joint& joint) {
    if (joint.turn.motion && coordinates_.turn)
        add({.factor = 0.0, .turn_factor = 1.0, .motor = Motor::turn});
    if (joint.slide.motion && coordinates_.slide)
        add({.is_length = true, .product = *coordinates_.slide, .motor = Motor::slide});
}

double JointRows::compute_prescribed(const Row& row, const JointMotors& motors, ConstraintLevel level) const {
    if (row.motor == Motor::none) return 0.0;
    const PrescribedCoordinate& prescribed = row.motor == Motor::turn ? motors.turn : motors.slide;
    return at_level({prescribed.value, prescribed.rate, prescribed.acceleration}, level);
}

int JointRows::find_motor_row(Motor motor) const {
    for (int row = 0; row < count_; ++row) {
        if (rows_[row].motor == motor) return row;
    }
    return -1;
}

JointVector JointRows::compute_values(const JointMotions& motions,
                                      double turn_before,
                                      const JointMotors& motors,
                                      ConstraintLevel level) const {
    JointVector values(count_);
    for (int i = 0; i < count_; ++i) {
        const Row& row = rows_[i];
        values[i] = -compute_prescribed(row, motors, level);
        if (row.factor != 0.0) values[i] += row.factor * at_level(row.product.compute_jet(motions), level);
        if (row.turn_factor != 0.0)
            values[i] +=
                row.turn_factor * at_level(coordinates_.turn->compute_jet(motions, turn_before), level);
        if (level == ConstraintLevel::position) values[i] += row.constant;
    }
    return values;
}

JointGap JointRows::compute_gap(const JointMotions& motions,
                                double turn_before,
                                const JointMotors& motors) const {
    const JointVector values = compute_values(motions, turn_before, motors, ConstraintLevel::position);
    JointGap gap;
    for (int i = 0; i < count_; ++i) {
        double& largest = rows_[i].is_length ? gap.length : gap.angle;
        largest = std::max(largest, std::abs(values[i]));
    }
    return gap;
}

JointMatrix JointRows::compute_gradient(const JointMotions& motions) const {
    JointMatrix gradient = JointMatrix::Zero(count_, 12);
    for (int i = 0; i < count_; ++i) {
        const Row& row = rows_[i];
        if (row.factor != 0.0) gradient.row(i) += row.factor * row.product.compute_gradient(motions);
        if (row.turn_factor != 0.0)
            gradient.row(i) += row.turn_factor * coordinates_.turn->compute_gradient(motions);
    }
    return gradient;
}

JointMatrix JointRows::compute_acceleration_derivative(const JointMotions& motions,
                                                       const JointLinearizations& linearizations) const {
    JointMatrix derivative = JointMatrix::Zero(count_, 12);
    for (int i = 0; i < count_; ++i) {
        const Row& row = rows_[i];
        if (row.factor != 0.0)
            derivative.row(i) += row.factor * row.product.differentiate(motions, linearizations).acceleration;
        if (row.turn_factor != 0.0)
            derivative.row(i) +=
                row.turn_factor * coordinates_.turn->differentiate(motions, linearizations).acceleration;
    }
    return derivative;
}

PairMatrix JointRows::compute_force_derivative(const JointMotions& motions,
                                               const JointVector& multipliers) const {
    PairMatrix derivative = PairMatrix::Zero();
    for (int i = 0; i < count_; ++i) {
        const Row& row = rows_[i];
        if (row.factor != 0.0)
            derivative += multipliers[i] * row.factor * row.product.compute_second_derivative(motions);
        if (row.turn_factor != 0.0)
            derivative +=
                multipliers[i] * row.turn_factor * coordinates_.turn->compute_second_derivative(motions);
    }
    return derivative;
}

}  // namespace gxrod
