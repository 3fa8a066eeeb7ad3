#include "constraints/joints/joint_rows.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "model/ties/joint_card.hpp"

namespace gxrod {

namespace {

// An axis of A's, or of B's, as the node carries it.
LinkVector carry_on_a(const Joint& joint, int axis) {
    return {LinkVector::Kind::on_a, joint.a.axes.col(axis)};
}
LinkVector carry_on_b(const Joint& joint, int axis) {
    return {LinkVector::Kind::on_b, joint.b.axes.col(axis)};
}
LinkVector separation() { return {LinkVector::Kind::separation}; }

// Whether a joint's point is its node, or a fixed one.
bool is_at_node(const Anchor& anchor) { return anchor.is_ground() || anchor.arm.isZero(0.0); }

}  // namespace

JointRows::JointRows(const Joint& joint) : arms_(arms_of(joint)), coordinates_(joint) {
    if (!joint.acts) {
        is_linear_ = true;
        return;
    }
    is_linear_ = (joint.kind == JointKind::ball || joint.kind == JointKind::weld) &&
                 is_at_node(joint.a.anchor) && is_at_node(joint.b.anchor);
    if (joint.clearance)
        add_loose(joint);
    else
        add_kind(joint);
    add_motors(joint);
    add_stops(joint);
}

// The equations below have the separation d = r_B − r_A of the points, and the axes a₁ a₂ a₃ that A carries
// and b₁ b₂ b₃ that B carries; the first of them is the joint's axis.
void JointRows::add_kind(const Joint& joint) {
    switch (joint.kind) {
        case JointKind::ball:  // d = 0
            return add_points();
        case JointKind::hinge:  // d = 0, a₁·b₂ = a₁·b₃ = 0
            add_points();
            return add_aligned_axes(joint);
        case JointKind::cylinder:  // a₂·d = a₃·d = 0, a₁·b₂ = a₁·b₃ = 0
            add_across(joint);
            return add_aligned_axes(joint);
        case JointKind::slider:  // a₂·d = a₃·d = 0, a₁·b₂ = a₂·b₃ = a₃·b₁ = 0
            add_across(joint);
            return add_equal_axes(joint);
        case JointKind::universal:  // d = 0, a₁·b₁ = 0
            add_points();
            return add({.product = {carry_on_a(joint, 0), carry_on_b(joint, 0)}});
        case JointKind::screw:  // as a cylinder, and slide − (lead/2π) ψ = 0 with the turn ψ
            add_across(joint);
            add_aligned_axes(joint);
            return add({.is_length = true,
                        .product = coordinates_.slide->product(),
                        .turn_factor = -0.5 * joint.lead / std::numbers::pi});
        case JointKind::plane:  // a₁·d = 0, a₁·b₂ = a₁·b₃ = 0
            add({.is_length = true, .product = {carry_on_a(joint, 0), separation()}});
            return add_aligned_axes(joint);
        case JointKind::weld:  // d = 0, a₁·b₂ = a₂·b₃ = a₃·b₁ = 0
            add_points();
            return add_equal_axes(joint);
        case JointKind::distance:  // (d·d/L − L)/2 = 0
            return add_distance(joint);
        case JointKind::generic:
            return add_held(joint);
        case JointKind::cam:  // D − ρ = 0
            return add_cam(joint);
        case JointKind::sleeve:
            assert(!"a sleeve has equations of its own");
            return;
        case JointKind::free:
            break;
    }
}

// With a clearance the points are free: of a ball in all directions, else across the axis.
void JointRows::add_loose(const Joint& joint) {
    const JointCard& card = card_of(joint.kind);
    if (!card.has_turn) return;
    if (!card.has_slide) add({.is_length = true, .product = {carry_on_a(joint, 0), separation()}});
    add_aligned_axes(joint);
}

// The points coincide: d = 0, by global components.
void JointRows::add_points() {
    for (int i = 0; i < 3; ++i)
        add({.is_length = true, .product = {{.vector = Vec3::Unit(i)}, separation()}});
}

// A's axis is at right angles to the other two of B.
void JointRows::add_aligned_axes(const Joint& joint) {
    for (const int across : {1, 2}) add({.product = {carry_on_a(joint, 0), carry_on_b(joint, across)}});
}

// A does not turn against B.
void JointRows::add_equal_axes(const Joint& joint) {
    for (int i = 0; i < 3; ++i) add({.product = {carry_on_a(joint, i), carry_on_b(joint, (i + 1) % 3)}});
}

// B's point is on A's axis.
void JointRows::add_across(const Joint& joint) {
    for (const int across : {1, 2})
        add({.is_length = true, .product = {carry_on_a(joint, across), separation()}});
}

void JointRows::add_distance(const Joint& joint) {
    Row row{.is_length = true,
            .factor = 0.5 / joint.length,
            .product = {separation(), separation()},
            .constant = -0.5 * joint.length};
    if (joint.pulls_only) row.upper = 0.0;
    has_stops_ = joint.pulls_only;
    add(row);
}

void JointRows::add_cam(const Joint& joint) {
    cam_.emplace(joint);
    Row row{.is_length = true, .factor = 0.0, .cam_factor = 1.0, .constant = -joint.cam->roller};
    if (joint.cam->lifts) row.lower = 0.0;
    has_stops_ = joint.cam->lifts;
    add(row);
}

// aᵢ·d = 0 for each displacement that is held. A turn that alone is free is that of a hinge, about aₖ; two
// that are free are those of a universal joint, about aᵢ, which A carries, and bⱼ, which B carries.
void JointRows::add_held(const Joint& joint) {
    const auto& held = joint.held;
    if (held[0] && held[1] && held[2]) {
        add_points();
    } else {
        for (int i = 0; i < 3; ++i) {
            if (held[i]) add({.is_length = true, .product = {carry_on_a(joint, i), separation()}});
        }
    }
    const auto turns = std::count(held.begin() + 3, held.end(), true);
    if (turns == 3) return add_equal_axes(joint);
    for (int k = 0; k < 3; ++k) {
        const int next = (k + 1) % 3, last = (k + 2) % 3;
        if (turns == 2 && !held[3 + k]) {
            add({.product = {carry_on_a(joint, k), carry_on_b(joint, next)}});
            add({.product = {carry_on_a(joint, k), carry_on_b(joint, last)}});
        }
        if (turns == 1 && held[3 + k])
            add({.product = {carry_on_a(joint, std::min(next, last)),
                             carry_on_b(joint, std::max(next, last))}});
    }
}

void JointRows::add_motors(const Joint& joint) {
    if (joint.turn.motion && coordinates_.turn)
        add({.factor = 0.0, .turn_factor = 1.0, .motor = Motor::turn});
    if (joint.slide.motion && coordinates_.slide)
        add({.is_length = true, .product = coordinates_.slide->product(), .motor = Motor::slide});
}

void JointRows::add_stops(const Joint& joint) {
    if (joint.turn.limits.are_rigid() && coordinates_.turn) {
        const CoordinateLimits& limits = joint.turn.limits;
        add({.factor = 0.0, .turn_factor = 1.0, .lower = limits.lower, .upper = limits.upper});
        has_stops_ = true;
    }
    if (joint.slide.limits.are_rigid() && coordinates_.slide) {
        const CoordinateLimits& limits = joint.slide.limits;
        add({.is_length = true,
             .product = coordinates_.slide->product(),
             .lower = limits.lower,
             .upper = limits.upper});
        has_stops_ = true;
    }
}

// The bound of a stop that is nearer to its coordinate.
double JointRows::find_bound(const Row& row, double coordinate) {
    if (!row.lower) return *row.upper;
    if (!row.upper) return *row.lower;
    return coordinate - *row.lower < *row.upper - coordinate ? *row.lower : *row.upper;
}

StopPlace JointRows::find_stop(int index, const JointMotions& motions, double turn_before) const {
    const Row& row = rows_[index];
    const JointFrames frames = compute_frames(motions, ConstraintLevel::velocity);
    const ScalarJet jet = row.turn_factor != 0.0  ? coordinates_.turn->compute_jet(frames, turn_before)
                          : row.cam_factor != 0.0 ? cam_->compute_jet(frames)
                                                  : row.product.compute_jet(frames);
    const double factor = row.factor + row.turn_factor + row.cam_factor;  // one of them is not 0
    const double coordinate = factor * jet.value + row.constant;
    const double rate = factor * jet.rate;
    const double bound = find_bound(row, coordinate);
    const double sign = row.upper && bound == *row.upper ? -1.0 : 1.0;
    return {sign * (coordinate - bound), -sign * rate, sign};
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
    const JointFrames frames = compute_frames(motions, level);
    JointVector values(count_);
    for (int i = 0; i < count_; ++i) {
        const Row& row = rows_[i];
        values[i] = -compute_prescribed(row, motors, level);
        if (row.factor != 0.0) values[i] += row.factor * at_level(row.product.compute_jet(frames), level);
        if (row.turn_factor != 0.0)
            values[i] +=
                row.turn_factor * at_level(coordinates_.turn->compute_jet(frames, turn_before), level);
        if (row.cam_factor != 0.0) values[i] += row.cam_factor * at_level(cam_->compute_jet(frames), level);
        if (level != ConstraintLevel::position) continue;
        values[i] += row.constant;
        if (is_stop(i)) values[i] -= find_bound(row, values[i]);
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
        const double open = is_stop(i) ? -find_stop(i, motions, turn_before).gap : std::abs(values[i]);
        largest = std::max(largest, open);
    }
    return gap;
}

JointMatrix JointRows::compute_gradient(const JointFrames& frames) const {
    JointMatrix gradient(count_, 12);
    for (int i = 0; i < count_; ++i) {
        const Row& row = rows_[i];
        PairRow sum = PairRow::Zero();
        if (row.factor != 0.0) row.product.add_gradient(frames, row.factor, sum);
        if (row.turn_factor != 0.0) coordinates_.turn->add_gradient(frames, row.turn_factor, sum);
        if (row.cam_factor != 0.0) cam_->add_gradient(frames, row.cam_factor, sum);
        gradient.row(i) = sum;
    }
    return gradient;
}

JointMatrix JointRows::compute_acceleration_derivative(const JointFrames& frames,
                                                       const JointLinearizations& linearizations) const {
    JointMatrix derivative(count_, 12);
    for (int i = 0; i < count_; ++i) {
        const Row& row = rows_[i];
        PairRow sum = PairRow::Zero();
        if (row.factor != 0.0) row.product.add_change(frames, linearizations, {0.0, 0.0, row.factor}, sum);
        if (row.turn_factor != 0.0)
            coordinates_.turn->add_change(frames, linearizations, {0.0, 0.0, row.turn_factor}, sum);
        if (row.cam_factor != 0.0) cam_->add_change(frames, linearizations, {0.0, 0.0, row.cam_factor}, sum);
        derivative.row(i) = sum;
    }
    return derivative;
}

JointReaction JointRows::compute_reaction(const JointFrames& frames, const JointVector& multipliers) const {
    JointReaction reaction;
    for (int i = 0; i < count_; ++i) {
        const Row& row = rows_[i];
        if (row.factor != 0.0) row.product.add_reaction(frames, multipliers[i] * row.factor, reaction);
        if (row.turn_factor != 0.0)
            coordinates_.turn->add_reaction(frames, multipliers[i] * row.turn_factor, reaction);
        if (row.cam_factor != 0.0) cam_->add_reaction(frames, multipliers[i] * row.cam_factor, reaction);
    }
    return reaction;
}

PairVector JointRows::compute_force(const JointFrames& frames, const JointVector& multipliers) const {
    return compute_reaction(frames, multipliers).compute_force(frames);
}

PairMatrix JointRows::compute_force_derivative(const JointFrames& frames,
                                               const JointVector& multipliers) const {
    return compute_reaction(frames, multipliers).compute_derivative(frames);
}

}  // namespace gxrod
