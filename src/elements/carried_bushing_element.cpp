#include "elements/carried_bushing_element.hpp"

#include "rotation/rotation_map.hpp"

namespace gxrod {

// Legend: R the bushing's axes, ω_R their spin; D from A to B, spatial; w = ω_B − ω_A; e the turn of B
// against A that the stiffness sees; n, m force and moment of the bushing, spatial; u arm from a node to its
// point (docs/theory/springs.md).

template <int Nodes>
CarriedBushingElement<Nodes>::CarriedBushingElement(const Bushing& bushing)
    : Base(bushing), turn_(find_bushing_turn(bushing)) {}

template <int Nodes>
CarriedBushingMotion CarriedBushingElement<Nodes>::compute_motion(const Motions<Nodes>& motions) const {
    const auto [a, b] = points_.at_ends(motions);
    return compute_carried_motion(bushing_, a, b);
}

template <int Nodes>
void CarriedBushingElement<Nodes>::add_force(const Motions<Nodes>& motions,
                                             const CarriedBushingMotion& motion,
                                             const Vec6& own,
                                             NodalVector<Nodes>& force) const {
    const Vec3 n = motion.axes * own.head<3>();
    const std::array<Vec3, 2> moments = distribute_moment(bushing_, motion, own.tail<3>());
    for (int i = 0; i < Nodes; ++i) {
        Vec3 moment = points_.sign(i) * points_.arm(motions, i).cross(n) + moments[end_of(i)];
        if (carries_axes(bushing_, end_of(i))) moment -= motion.distance.d.cross(n);
        force.template segment<3>(6 * i) += points_.sign(i) * n;
        force.template segment<3>(6 * i + 3) += moment;
    }
}

template <int Nodes>
typename CarriedBushingElement<Nodes>::Variation CarriedBushingElement<Nodes>::vary(
    const Motions<Nodes>& motions,
    const CarriedBushingMotion& motion,
    const Linearizations<Nodes>& linear) const {
    Variation variation;
    variation.d = points_.differentiate_distance(motions, linear);
    variation.axes.setZero();
    variation.turn.setZero();
    for (int i = 0; i < Nodes; ++i) {
        const std::size_t end = end_of(i);
        const double by = linear[i]->placement;
        variation.turn.template middleCols<3>(6 * i + 3) = by * motion.turn.by[end];
        if (carries_axes(bushing_, end))
            variation.axes.template middleCols<3>(6 * i + 3) = by * Mat3::Identity();
    }
    return variation;
}

// δ(Rᵀ D) = Rᵀ (δD + D × δφ_R), δ(Rᵀ e) likewise.
template <int Nodes>
typename CarriedBushingElement<Nodes>::StrainColumns CarriedBushingElement<Nodes>::differentiate_strain(
    const CarriedBushingMotion& motion, const Variation& variation) const {
    const Mat3 to_axes = motion.axes.transpose();
    StrainColumns columns;
    columns << to_axes * (variation.d + spin(motion.distance.d) * variation.axes),
        to_axes * (variation.turn + spin(motion.turn.v) * variation.axes);
    return columns;
}

// The rates are Rᵀ (Ḋ + D × ω_R), and Rᵀ (ė + e × ω_R) or Rᵀ w, with b · w of a twist in addition.
template <int Nodes>
typename CarriedBushingElement<Nodes>::StrainColumns CarriedBushingElement<Nodes>::differentiate_rate(
    const Motions<Nodes>& motions,
    const CarriedBushingMotion& motion,
    const Linearizations<Nodes>& linear,
    const Variation& variation) const {
    const Mat3 to_axes = motion.axes.transpose();
    const Vec3& D = motion.distance.d;
    const Vec3& e = motion.turn.v;
    Columns by_w = Columns::Zero();
    Columns by_spin = Columns::Zero();
    Columns by_change = Columns::Zero();
    Columns by_twist = Columns::Zero();
    for (int i = 0; i < Nodes; ++i) {
        const std::size_t end = end_of(i);
        const double placement = linear[i]->placement;
        const Mat3& d_omega = linear[i]->d_omega;
        by_w.template middleCols<3>(6 * i + 3) = points_.sign(i) * d_omega;
        if (carries_axes(bushing_, end)) by_spin.template middleCols<3>(6 * i + 3) = d_omega;
        by_change.template middleCols<3>(6 * i + 3) =
            motion.turn.by[end] * d_omega + placement * motion.turn_change.by[end];
        by_twist.template middleCols<3>(6 * i + 3) = placement * motion.twist.by[end];
    }
    const Vec3 seen = motion.distance.rate + D.cross(motion.axes_spin);
    const Columns by_seen = points_.differentiate_rate(motions, linear) + spin(D) * by_spin -
                            spin(motion.axes_spin) * variation.d;
    StrainColumns columns;
    columns.template topRows<3>() = to_axes * (by_seen + spin(seen) * variation.axes);
    if (turn_.kind == BushingTurn::Kind::spin) {
        columns.template bottomRows<3>() = to_axes * (by_w + spin(motion.turn_rate) * variation.axes);
        return columns;
    }
    const Vec3 turned = motion.turn_change.v + e.cross(motion.axes_spin);
    const Columns by_turned = by_change + spin(e) * by_spin - spin(motion.axes_spin) * variation.turn;
    columns.template bottomRows<3>() = to_axes * (by_turned + spin(turned) * variation.axes);
    columns.row(3 + turn_.axis) +=
        motion.twist.v.transpose() * by_w + motion.turn_rate.transpose() * by_twist;
    return columns;
}

template <int Nodes>
std::array<typename CarriedBushingElement<Nodes>::Columns, 2>
CarriedBushingElement<Nodes>::differentiate_moments_on_ends(const Motions<Nodes>& motions,
                                                            const CarriedBushingMotion& motion,
                                                            const Linearizations<Nodes>& linear,
                                                            const Variation& variation,
                                                            const Vec3& own,
                                                            const StrainColumns& derivative) const {
    const Vec3 m = motion.axes * own;
    const Columns by_m = motion.axes * derivative.template bottomRows<3>() - spin(m) * variation.axes;
    if (turn_.kind == BushingTurn::Kind::spin) return {-by_m, by_m};
    const auto [a, b] = points_.at_ends(motions);
    const auto by_spins = differentiate_moments(bushing_, motion, a, b, own);
    std::array<Columns, 2> by_moments;
    for (std::size_t end = 0; end < 2; ++end) {
        const double sign = end == 0 ? -1.0 : 1.0;
        by_moments[end] =
            motion.turn.by[end].transpose() * by_m + sign * motion.twist.v * derivative.row(3 + turn_.axis);
        if (carries_axes(bushing_, end))
            by_moments[end] += spin(m) * variation.turn - spin(motion.turn.v) * by_m;
        for (int i = 0; i < Nodes; ++i)
            by_moments[end].template middleCols<3>(6 * i + 3) +=
                linear[i]->placement * by_spins[end][end_of(i)];
    }
    return by_moments;
}

template <int Nodes>
void CarriedBushingElement<Nodes>::add_tangent(const Motions<Nodes>& motions,
                                               const CarriedBushingMotion& motion,
                                               const Linearizations<Nodes>& linear,
                                               const Variation& variation,
                                               const OwnForce& own,
                                               NodalMatrix<Nodes>& tangent) const {
    const Vec3 n = motion.axes * own.value.template head<3>();
    const Columns by_n = motion.axes * own.derivative.template topRows<3>() - spin(n) * variation.axes;
    const auto by_moments = differentiate_moments_on_ends(
        motions, motion, linear, variation, own.value.template tail<3>(), own.derivative);
    for (int i = 0; i < Nodes; ++i) {
        const double sign = points_.sign(i);
        const Mat3 spin_u = spin(points_.arm(motions, i));
        Columns by_moment = sign * spin_u * by_n + by_moments[end_of(i)];
        if (carries_axes(bushing_, end_of(i)))
            by_moment += spin(n) * variation.d - spin(motion.distance.d) * by_n;
        tangent.template middleRows<3>(6 * i) += sign * by_n;
        tangent.template middleRows<3>(6 * i + 3) += by_moment;
        tangent.template block<3, 3>(6 * i + 3, 6 * i + 3) += sign * linear[i]->placement * spin(n) * spin_u;
    }
}

// What has no strain, spins and the twist, is measured by the rotations of both ends in the step, half way.
template <int Nodes>
double CarriedBushingElement<Nodes>::damping_action(const Motions<Nodes>& before,
                                                    const Motions<Nodes>& after,
                                                    Histories) const {
    if (!this->is_damped()) return 0.0;
    const CarriedBushingMotion first = compute_motion(before);
    const CarriedBushingMotion last = compute_motion(after);
    Vec3 turned = Vec3::Zero();
    for (int i = 0; i < Nodes; ++i)
        turned += points_.sign(i) * log(Quat(after[i]->Lambda * before[i]->Lambda.conjugate()));
    Vec6 change = last.strain - first.strain;
    if (turn_.kind == BushingTurn::Kind::spin) {
        const Mat3 half = exp_matrix(0.5 * log(Mat3(first.axes.transpose() * last.axes)));
        change.tail<3>() = (first.axes * half).transpose() * turned;
    } else {
        change[3 + turn_.axis] += 0.5 * (first.twist.v + last.twist.v).dot(turned);
    }
    return change.dot(bushing_.damping * change);
}

template <int Nodes>
double CarriedBushingElement<Nodes>::largest_relative_rotation(const Motions<Nodes>& motions) const {
    return compute_motion(motions).turn.v.norm();
}

template class CarriedBushingElement<1>;
template class CarriedBushingElement<2>;

}  // namespace gxrod
