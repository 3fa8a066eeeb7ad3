#include "constraints/joints/joint_coordinate.hpp"

#include <cmath>
#include <complex>
#include <numbers>

#include "model/ties/joint_card.hpp"

namespace gxrod {

namespace {

using Complex = std::complex<double>;
using Kind = LinkVector::Kind;

constexpr double whole_turn = 2.0 * std::numbers::pi;

// z = x + iy.
Jet<Complex> combine(const ScalarJet& x, const ScalarJet& y) {
    return {{x.value, y.value}, {x.rate, y.rate}, {x.acceleration, y.acceleration}};
}

// The direction on B whose turn is that of the joint: B's own axis if it has one, else one across the axis.
Vec3 choose_hand(const Joint& joint) { return joint.b.axes.col(card_of(joint.kind).has_axis_b ? 0 : 1); }

// Turns need no points.
JointFrames turn_frames(const JointMotions& motions, ConstraintLevel level) { return {motions, {}, level}; }

}  // namespace

JointArms arms_of(const Joint& joint) { return {joint.a.anchor.arm, joint.b.anchor.arm}; }

JointTurn::JointTurn(const Joint& joint)
    : is_twist_(joint.kind == JointKind::free), axis_(joint.a.axes.col(0)) {
    hands_[0] = choose_hand(joint);
    hands_[1] = axis_.cross(hands_[0]);
    for (std::size_t i = 0; i < hands().size(); ++i) {
        across_[i] = axis_.cross(hands_[i]);
        x_[i] = LinkProduct({Kind::on_a, hands_[i]}, {Kind::on_b, hands_[i]});
        y_[i] = LinkProduct({Kind::on_a, across_[i]}, {Kind::on_b, hands_[i]});
    }
}

Jet<Complex> JointTurn::compute_z(const JointFrames& frames) const {
    Jet<Complex> z = combine(x_[0].compute_jet(frames), y_[0].compute_jet(frames));
    if (!is_twist_) return z;
    const Jet<Complex> other = combine(x_[1].compute_jet(frames), y_[1].compute_jet(frames));
    return {z.value + other.value, z.rate + other.rate, z.acceleration + other.acceleration};
}

double JointTurn::guess(const JointMotions& motions, double turn_before) const {
    return turn_before + (motions.a.Lambda * axis_).dot(motions.b.theta - motions.a.theta);
}

ScalarJet JointTurn::compute_jet(const JointFrames& frames, double turn_before) const {
    const auto [z, z_rate, z_acceleration] = compute_z(frames);
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

std::array<JointTurn::Place, 2> JointTurn::find_places(const JointFrames& frames) const {
    std::array<Vec3, 2> w{}, e1{}, e2{};
    double x = 0.0, y = 0.0;
    for (std::size_t i = 0; i < hands().size(); ++i) {
        w[i] = frames.R_b * hands_[i];
        e1[i] = frames.R_a * hands_[i];
        e2[i] = frames.R_a * across_[i];
        x += w[i].dot(e1[i]);
        y += w[i].dot(e2[i]);
    }
    const double square = x * x + y * y;
    std::array<Place, 2> places{};
    for (std::size_t i = 0; i < hands().size(); ++i)
        places[i] = {(x * e2[i] - y * e1[i]) / square, (x * e1[i] + y * e2[i]) / square, w[i]};
    return places;
}

void JointTurn::add_gradient(const JointFrames& frames, double factor, PairRow& row) const {
    const std::array<Place, 2> places = find_places(frames);
    for (std::size_t i = 0; i < hands().size(); ++i) {
        const Vec3 moment = factor * places[i].u.cross(places[i].w);
        row.segment<3>(3) += moment;
        row.segment<3>(9) -= moment;
    }
}

void JointTurn::add_change(const JointFrames& frames,
                           const JointLinearizations& linearizations,
                           const ScalarJet& weights,
                           PairRow& row) const {
    const auto [z, z_rate, z_acceleration] = compute_z(frames);
    const Complex inverse = 1.0 / z;
    const Complex growth = z_rate * inverse;
    const Complex curvature = 2.0 * growth * growth - z_acceleration * inverse;
    // δz, δż and δz̈ are multiplied by these.
    const Complex of_acceleration = weights.acceleration * inverse;
    const Complex of_rate = (weights.rate - 2.0 * weights.acceleration * growth) * inverse;
    const Complex of_value =
        (weights.value - weights.rate * growth + weights.acceleration * curvature) * inverse;
    const ScalarJet of_x{of_value.imag(), of_rate.imag(), of_acceleration.imag()};
    const ScalarJet of_y{of_value.real(), of_rate.real(), of_acceleration.real()};
    for (std::size_t i = 0; i < hands().size(); ++i) {
        x_[i].add_change(frames, linearizations, of_x, row);
        y_[i].add_change(frames, linearizations, of_y, row);
    }
}

void JointTurn::add_reaction(const JointFrames& frames, double multiplier, JointReaction& reaction) const {
    const std::array<Place, 2> places = find_places(frames);
    Vec3 of_turn = Vec3::Zero(), of_size = Vec3::Zero();
    for (std::size_t i = 0; i < hands().size(); ++i) {
        const auto& [u, v, w] = places[i];
        reaction.moments += multiplier * u * w.transpose();
        of_turn += u.cross(w);
        of_size += v.cross(w);
    }
    const Mat3 bend = multiplier * of_turn * of_size.transpose();
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
