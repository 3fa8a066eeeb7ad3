#include "constraints/joints/play/clearance_force.hpp"

#include <cmath>
#include <unsupported/Eigen/AutoDiff>

#include "constraints/joints/play/bound_push.hpp"
#include "model/ties/joint_card.hpp"
#include "rotation/cross_products.hpp"

namespace gxrod {

namespace {

// The numbers by which a contact acts: d, ḋ, the axis, ω_A, ω_B.
constexpr int place_numbers = 15;
using Contacting = Eigen::AutoDiffScalar<Eigen::Matrix<double, place_numbers, 1>>;
using PlaceJacobian = Eigen::Matrix<double, 3, place_numbers>;
using PlaceByUnknowns = Eigen::Matrix<double, place_numbers, 12>;

template <class Number>
using Vector = Eigen::Matrix<Number, 3, 1>;

// The push as a number of the same kind as its arguments.
double push_at(const CoordinateLimits& contact, double depth, double rate) {
    return compute_bound_push(contact, depth, rate).force;
}
Contacting push_at(const CoordinateLimits& contact, const Contacting& depth, const Contacting& rate) {
    const BoundPush push = compute_bound_push(contact, depth.value(), rate.value());
    return {push.force, push.by_depth * depth.derivatives() + push.by_rate * rate.derivatives()};
}

Vector<Contacting> vary(const Vec3& vector, int first) {
    Vector<Contacting> varied;
    for (int k = 0; k < 3; ++k) varied[k] = Contacting(vector[k], place_numbers, first + k);
    return varied;
}

PlaceJacobian derivatives_of(const Vector<Contacting>& vector) {
    PlaceJacobian derivatives;
    for (int k = 0; k < 3; ++k) derivatives.row(k) = vector[k].derivatives().transpose();
    return derivatives;
}

// Adds the part of one side: its point is r + s with the arm s, and moves with v + ω × s.
void add_point(double sign,
               const Vec3& arm,
               const NodeMotion& motion,
               const NodeLinearization& linearization,
               int first,
               PlaceByUnknowns& by_unknowns) {
    const Mat3 S = cross_matrix(arm);
    by_unknowns.block<3, 3>(0, first) += sign * linearization.placement * Mat3::Identity();
    by_unknowns.block<3, 3>(0, first + 3) -= sign * linearization.placement * S;
    by_unknowns.block<3, 3>(3, first) += sign * linearization.rate * Mat3::Identity();
    by_unknowns.block<3, 3>(3, first + 3) -=
        sign * (S * linearization.d_omega + linearization.placement * cross_matrix(motion.omega) * S);
}

}  // namespace

template <class Number>
struct ClearanceForce::Place {
    Vector<Number> separation, rate;  // d, ḋ
    Vector<Number> axis;              // carried by A; 0 without one
    Vector<Number> omega_a, omega_b;
};

template <class Number>
struct ClearanceForce::Exerted {
    Vector<Number> force = Vector<Number>::Zero();
    Vector<Number> moment = Vector<Number>::Zero();
};

ClearanceForce::ClearanceForce(const Joint& joint)
    : arms_{joint.a.anchor.arm, joint.b.anchor.arm},
      has_axis_(card_of(joint.kind).has_turn),
      axis_(has_axis_ ? Vec3(joint.a.axes.col(0)) : Vec3::Zero()),
      law_(*joint.clearance) {}

ClearanceForce::Place<double> ClearanceForce::find_place(const JointFrames& frames) const {
    const auto& [a, b] = frames.motions;
    return {frames.separation.value, frames.separation.rate, frames.R_a * axis_, a.omega, b.omega};
}

// (J34) to (J36), in a frame that turns with A.
template <class Number>
ClearanceForce::Exerted<Number> ClearanceForce::compute_exerted(const Place<Number>& place) const {
    using std::sqrt;
    const auto& [d, d_rate, axis, omega_a, omega_b] = place;
    const Vector<Number> across = d - axis * axis.dot(d);
    const Number distance = sqrt(across.dot(across));
    const Number depth = distance - *law_.contact.upper;
    if (!(depth > 0.0)) return {};
    const Vector<Number> n = across / distance;
    const Vector<Number> moved = d_rate - omega_a.cross(d);
    const Number push = push_at(law_.contact, depth, n.dot(moved));
    Exerted<Number> exerted;
    exerted.force = -n * push;
    if (law_.friction == 0.0) return exerted;
    const Vector<Number> lever = n * Number(law_.radius);
    const Vector<Number> slip = moved + (omega_b - omega_a).cross(lever);
    const Vector<Number> along = slip - n * n.dot(slip);
    const Number speed = sqrt(along.dot(along) + law_.slip_speed * law_.slip_speed);
    exerted.force -= along * Number(push * law_.friction / speed);
    exerted.moment = lever.cross(exerted.force);
    return exerted;
}

double ClearanceForce::compute_distance(const JointMotions& motions) const {
    const Place<double> place = find_place(frames_of(motions));
    return (place.separation - place.axis * place.axis.dot(place.separation)).norm();
}

PairRow ClearanceForce::compute_force(const JointMotions& motions) const {
    const JointFrames frames = frames_of(motions);
    const auto [force, moment] = compute_exerted(find_place(frames));
    PairRow exerted;
    exerted << -force.transpose(),
        -((frames.arm_a.value + frames.separation.value).cross(force) + moment).transpose(),
        force.transpose(), (frames.arm_b.value.cross(force) + moment).transpose();
    return exerted;
}

PairMatrix ClearanceForce::compute_tangent(const JointMotions& motions,
                                           const JointLinearizations& linearizations) const {
    PairMatrix tangent = PairMatrix::Zero();
    const JointFrames frames = frames_of(motions);
    const Place<double> at = find_place(frames);
    if (compute_exerted(at).force.isZero(0.0)) return tangent;
    const Exerted<Contacting> exerted = compute_exerted<Contacting>({vary(at.separation, 0),
                                                                     vary(at.rate, 3),
                                                                     vary(at.axis, 6),
                                                                     vary(at.omega_a, 9),
                                                                     vary(at.omega_b, 12)});
    const auto& [a, b] = linearizations;
    const Vec3 &arm_a = frames.arm_a.value, &arm_b = frames.arm_b.value;
    PlaceByUnknowns by_unknowns = PlaceByUnknowns::Zero();
    add_point(-1.0, arm_a, motions.a, a, 0, by_unknowns);
    add_point(1.0, arm_b, motions.b, b, 6, by_unknowns);
    by_unknowns.block<3, 3>(6, 3) = -a.placement * cross_matrix(at.axis);
    by_unknowns.block<3, 3>(9, 3) = a.d_omega;
    by_unknowns.block<3, 3>(12, 9) = b.d_omega;
    const PairJacobian of_force = derivatives_of(exerted.force) * by_unknowns;
    const PairJacobian of_moment = derivatives_of(exerted.moment) * by_unknowns;
    const Mat3 F =
        cross_matrix(Vec3(exerted.force[0].value(), exerted.force[1].value(), exerted.force[2].value()));
    tangent.middleRows<3>(0) = -of_force;
    tangent.middleRows<3>(3) =
        -cross_matrix(Vec3(arm_a + at.separation)) * of_force + F * by_unknowns.topRows<3>() - of_moment;
    tangent.block<3, 3>(3, 3) -= a.placement * F * cross_matrix(arm_a);
    tangent.middleRows<3>(6) = of_force;
    tangent.middleRows<3>(9) = cross_matrix(arm_b) * of_force + of_moment;
    tangent.block<3, 3>(9, 9) += b.placement * F * cross_matrix(arm_b);
    return tangent;
}

double ClearanceForce::compute_energy(const JointMotions& motions) const {
    const double depth = compute_distance(motions) - *law_.contact.upper;
    return depth > 0.0 ? compute_bound_energy(law_.contact, depth) : 0.0;
}

// What the motions of both sides lose, less what the contact stores.
double ClearanceForce::compute_damping_power(const JointMotions& motions) const {
    const JointFrames frames = frames_of(motions);
    const Place<double> place = find_place(frames);
    const double distance = compute_distance(motions);
    const double depth = distance - *law_.contact.upper;
    if (!(depth > 0.0) || !dissipates()) return 0.0;
    const Vec3 n = (place.separation - place.axis * place.axis.dot(place.separation)) / distance;
    const Vec3 moved = place.rate - place.omega_a.cross(place.separation);
    const auto [force, moment] = compute_exerted(place);
    const BoundPush push = compute_bound_push(law_.contact, depth, n.dot(moved));
    return -force.dot(moved) - moment.dot(place.omega_b - place.omega_a) - push.elastic * n.dot(moved);
}

}  // namespace gxrod
