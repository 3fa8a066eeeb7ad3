#include "elements/bushing_element.hpp"

#include "rotation/rotation_map.hpp"

namespace gxrod {

// Legend: R the bushing's axes; D from A to B, spatial; w = ω_B − ω_A; Φ, τ, X of the rotation of B against A
// (rotation/half_rotation.hpp); n, m force and moment of the bushing, spatial; u arm from a node to its point
// (docs/theory/springs.md).

namespace {

Mat3 build_rate_map(const HalfRotation<double>& turn) {
    return turn.x * Mat3::Identity() + turn.y * turn.Phi * turn.Phi.transpose();
}

// Of X v by Φ at fixed v.
Mat3 differentiate_rate_map(const HalfRotation<double>& turn, const Vec3& v) {
    const Vec3& Phi = turn.Phi;
    const double along = Phi.dot(v);
    return turn.x1 * v * Phi.transpose() + turn.y1 * along * Phi * Phi.transpose() +
           turn.y * (Phi * v.transpose() + along * Mat3::Identity());
}

}  // namespace

template <int Nodes>
BushingElement<Nodes>::BushingElement(const Bushing& bushing) : Base(bushing) {}

template <int Nodes>
BushingMotion BushingElement<Nodes>::compute_motion(const Motions<Nodes>& motions) const {
    const auto [a, b] = points_.at_ends(motions);
    return compute_bushing_motion(bushing_, a, b);
}

template <int Nodes>
void BushingElement<Nodes>::add_force(const Motions<Nodes>& motions,
                                      const BushingMotion& motion,
                                      const Vec6& own,
                                      NodalVector<Nodes>& force) const {
    const Vec3 n = motion.axes * own.head<3>();
    const Vec3 m = motion.axes * take_to_rotation_vector(motion.turn, own.tail<3>());
    const Vec3 tau = motion.axes * motion.turn.tau;
    const Vec3 moment_of_n = motion.distance.d.cross(n);
    for (int i = 0; i < Nodes; ++i) {
        const double sign = points_.sign(i);
        force.template segment<3>(6 * i) += sign * n;
        force.template segment<3>(6 * i + 3) +=
            sign * (points_.arm(motions, i).cross(n) + m + 0.5 * moment_of_n.cross(tau)) - 0.5 * moment_of_n;
    }
}

template <int Nodes>
typename BushingElement<Nodes>::Variation BushingElement<Nodes>::vary(
    const Motions<Nodes>& motions, const BushingMotion& motion, const Linearizations<Nodes>& linear) const {
    const HalfRotation<double>& turn = motion.turn;
    Columns mean = Columns::Zero();
    Variation variation;
    variation.d = points_.differentiate_distance(motions, linear);
    variation.turn.setZero();
    for (int i = 0; i < Nodes; ++i) {
        const Mat3 by_node = linear[i]->placement * Mat3::Identity();
        variation.turn.template middleCols<3>(6 * i + 3) = points_.sign(i) * by_node;
        mean.template middleCols<3>(6 * i + 3) = 0.5 * by_node;
    }
    const Vec3 tau = motion.axes * turn.tau;
    variation.middle = mean - 0.5 * spin(tau) * variation.turn;
    variation.rotation = build_rate_map(turn) * motion.axes.transpose() * variation.turn;
    const Mat3 of_tau = turn.t * Mat3::Identity() + turn.t1 * turn.Phi * turn.Phi.transpose();
    variation.tau = motion.axes * of_tau * variation.rotation - spin(tau) * variation.middle;
    return variation;
}

template <int Nodes>
typename BushingElement<Nodes>::StrainColumns BushingElement<Nodes>::differentiate_strain(
    const BushingMotion& motion, const Variation& variation) const {
    StrainColumns columns;
    columns << motion.axes.transpose() * (variation.d + spin(motion.distance.d) * variation.middle),
        variation.rotation;
    return columns;
}

// ḋ = Rᵀ (Ḋ − ω_m × D), Φ̇ = X Rᵀ w.
template <int Nodes>
typename BushingElement<Nodes>::StrainColumns BushingElement<Nodes>::differentiate_rate(
    const Motions<Nodes>& motions,
    const BushingMotion& motion,
    const Linearizations<Nodes>& linear,
    const Variation& variation) const {
    const Mat3 to_axes = motion.axes.transpose();
    const Vec3& D = motion.distance.d;
    const Vec3& w = motion.turn_rate;
    const Vec3 tau = motion.axes * motion.turn.tau;
    Columns by_w = Columns::Zero();
    Columns by_mean = Columns::Zero();
    for (int i = 0; i < Nodes; ++i) {
        by_w.template middleCols<3>(6 * i + 3) = points_.sign(i) * linear[i]->d_omega;
        by_mean.template middleCols<3>(6 * i + 3) = 0.5 * linear[i]->d_omega;
    }
    const Columns by_spin = by_mean + 0.5 * (spin(w) * variation.tau - spin(tau) * by_w);
    const Vec3 seen = motion.distance.rate - motion.middle_spin.cross(D);
    const Columns by_seen = points_.differentiate_rate(motions, linear) + spin(D) * by_spin -
                            spin(motion.middle_spin) * variation.d;
    StrainColumns columns;
    columns << to_axes * (by_seen + spin(seen) * variation.middle),
        build_rate_map(motion.turn) * to_axes * (by_w + spin(w) * variation.middle) +
            differentiate_rate_map(motion.turn, to_axes * w) * variation.rotation;
    return columns;
}

template <int Nodes>
void BushingElement<Nodes>::add_tangent(const Motions<Nodes>& motions,
                                        const BushingMotion& motion,
                                        const Linearizations<Nodes>& linear,
                                        const Variation& variation,
                                        const OwnForce& own,
                                        NodalMatrix<Nodes>& tangent) const {
    const Mat3& R = motion.axes;
    const Vec3& D = motion.distance.d;
    const Vec3 own_moment = own.value.template tail<3>();
    const Vec3 n = R * own.value.template head<3>();
    const Vec3 m = R * take_to_rotation_vector(motion.turn, own_moment);
    const Vec3 tau = R * motion.turn.tau;
    const Vec3 moment_of_n = D.cross(n);
    const Columns by_n = R * own.derivative.template topRows<3>() - spin(n) * variation.middle;
    const Columns by_m = R * (build_rate_map(motion.turn) * own.derivative.template bottomRows<3>() +
                              differentiate_rate_map(motion.turn, own_moment) * variation.rotation) -
                         spin(m) * variation.middle;
    const Columns by_moment_of_n = spin(D) * by_n - spin(n) * variation.d;
    const Columns by_couple = by_m + 0.5 * (spin(moment_of_n) * variation.tau - spin(tau) * by_moment_of_n);
    for (int i = 0; i < Nodes; ++i) {
        const double sign = points_.sign(i);
        const Mat3 spin_u = spin(points_.arm(motions, i));
        tangent.template middleRows<3>(6 * i) += sign * by_n;
        tangent.template middleRows<3>(6 * i + 3) +=
            sign * (spin_u * by_n + by_couple) - 0.5 * by_moment_of_n;
        tangent.template block<3, 3>(6 * i + 3, 6 * i + 3) += sign * linear[i]->placement * spin(n) * spin_u;
    }
}

template <int Nodes>
double BushingElement<Nodes>::damping_action(const Motions<Nodes>& before,
                                             const Motions<Nodes>& after,
                                             Histories) const {
    if (!this->is_damped()) return 0.0;
    const Vec6 change = compute_motion(after).strain - compute_motion(before).strain;
    return change.dot(bushing_.damping * change);
}

template <int Nodes>
double BushingElement<Nodes>::largest_relative_rotation(const Motions<Nodes>& motions) const {
    return compute_motion(motions).turn.Phi.norm();
}

template class BushingElement<1>;
template class BushingElement<2>;

}  // namespace gxrod
