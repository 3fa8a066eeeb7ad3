#include "elements/spring_element.hpp"

#include <algorithm>

#include "elements/spring_law_energy.hpp"
#include "rotation/rotation_map.hpp"

namespace gxrod {

// Legend: u = Λ b arm from a node to its point, spatial; d from point A to point B, ℓ = |d|, e = d/ℓ; N axial
// force; F force on point B that the spring asks for, −F on A (docs/theory/springs.md).

template <int Nodes>
SpringElement<Nodes>::SpringElement(const Spring& spring)
    : TwoPointElement<Nodes>(spring.ends), spring_(spring) {}

template <int Nodes>
SpringLine SpringElement<Nodes>::compute_line(const Motions<Nodes>& motions) const {
    const auto [a, b] = points_.at_ends(motions);
    return compute_spring_line(spring_, a, b);
}

// A spring without a length of its own pulls by k d, also where d has no direction. Of others the force is
// not a number there, and the step is cut.
template <int Nodes>
Vec3 SpringElement<Nodes>::compute_elastic_force(const SpringLine& line) const {
    if (is_plain()) return spring_.stiffness * line.d;
    return compute_elastic_tension(spring_, line.length) * line.direction;
}

// ∂F/∂d = N′ e eᵀ + N/ℓ (1 − e eᵀ), ′ by ℓ.
template <int Nodes>
Mat3 SpringElement<Nodes>::compute_stiffness(const SpringLine& line) const {
    if (is_plain()) return spring_.stiffness * Mat3::Identity();
    const double across = compute_elastic_tension(spring_, line.length) / line.length;
    double along = spring_.stiffness;
    if (spring_.law) along += spring_.law->differentiate_by_length(line.length, 0.0);
    return across * Mat3::Identity() + (along - across) * line.direction * line.direction.transpose();
}

template <int Nodes>
void SpringElement<Nodes>::add_force(const Motions<Nodes>& motions,
                                     const Vec3& at_B,
                                     NodalVector<Nodes>& force) const {
    for (int i = 0; i < Nodes; ++i) {
        const Vec3 F = points_.sign(i) * at_B;
        force.template segment<3>(6 * i) += F;
        force.template segment<3>(6 * i + 3) += points_.arm(motions, i).cross(F);
    }
}

template <int Nodes>
void SpringElement<Nodes>::add_tangent(const Motions<Nodes>& motions,
                                       const Linearizations<Nodes>& linear,
                                       const Vec3& at_B,
                                       const Columns& derivative,
                                       NodalMatrix<Nodes>& tangent) const {
    for (int i = 0; i < Nodes; ++i) {
        const Mat3 spin_u = spin(points_.arm(motions, i));
        tangent.template middleRows<3>(6 * i) += points_.sign(i) * derivative;
        tangent.template middleRows<3>(6 * i + 3) += points_.sign(i) * spin_u * derivative;
        tangent.template block<3, 3>(6 * i + 3, 6 * i + 3) +=
            points_.sign(i) * linear[i]->placement * spin(at_B) * spin_u;
    }
}

template <int Nodes>
void SpringElement<Nodes>::add_internal_force(const Motions<Nodes>& motions,
                                              Histories,
                                              NodalVector<Nodes>& force) const {
    add_force(motions, compute_elastic_force(compute_line(motions)), force);
}

template <int Nodes>
void SpringElement<Nodes>::add_internal_tangent(const Motions<Nodes>& motions,
                                                Histories,
                                                const Linearizations<Nodes>& linear,
                                                NodalMatrix<Nodes>& tangent) const {
    const SpringLine line = compute_line(motions);
    const Columns derivative = compute_stiffness(line) * points_.differentiate_distance(motions, linear);
    add_tangent(motions, linear, compute_elastic_force(line), derivative, tangent);
}

template <int Nodes>
void SpringElement<Nodes>::add_damping_force(const Motions<Nodes>& motions,
                                             Histories,
                                             NodalVector<Nodes>& force) const {
    const SpringLine line = compute_line(motions);
    if (!is_damped() || line.length == 0.0) return;
    add_force(
        motions, compute_damper_tension(spring_, line.length, line.length_rate) * line.direction, force);
}

// F = D e, D the damper's tension by ℓ and ℓ̇ = e · ḋ: δF = e (D_ℓ̇ (e · δḋ + ḋ · δe) + D_ℓ e · δd) + D δe,
// δe = (1 − e eᵀ) δd / ℓ.
template <int Nodes>
void SpringElement<Nodes>::add_damping_tangent(const Motions<Nodes>& motions,
                                               Histories,
                                               const Linearizations<Nodes>& linear,
                                               NodalMatrix<Nodes>& tangent) const {
    const SpringLine line = compute_line(motions);
    if (!is_damped() || line.length == 0.0) return;
    const DamperSlopes slopes = differentiate_damper(line, linear);
    const double tension = compute_damper_tension(spring_, line.length, line.length_rate);
    const Vec3& e = line.direction;
    const Mat3 turning = (Mat3::Identity() - e * e.transpose()) / line.length;
    const Mat3 by_line = slopes.by_length * e * e.transpose() +
                         (slopes.by_rate * e * line.rate.transpose() + tension * Mat3::Identity()) * turning;
    const Columns derivative =
        slopes.by_rate * e * (e.transpose() * points_.differentiate_rate(motions, linear)) +
        by_line * points_.differentiate_distance(motions, linear);
    add_tangent(motions, linear, tension * e, derivative, tangent);
}

template <int Nodes>
typename SpringElement<Nodes>::DamperSlopes SpringElement<Nodes>::differentiate_damper(
    const SpringLine& line, const Linearizations<Nodes>& linear) const {
    DamperSlopes slopes{.by_length = 0.0, .by_rate = spring_.damping};
    if (!spring_.law || !spring_.law->has_rate()) return slopes;
    const SpringLaw& law = *spring_.law;
    double rates = 0.0;
    for (const NodeLinearization* node : linear) rates = std::max({rates, node->rate, node->d_omega.norm()});
    slopes.by_length = law.differentiate_by_length(line.length, line.length_rate) -
                       law.differentiate_by_length(line.length, 0.0);
    slopes.by_rate += law.differentiate_by_rate(line.length, line.length_rate, rates);
    return slopes;
}

template <int Nodes>
double SpringElement<Nodes>::damping_action(const Motions<Nodes>& before,
                                            const Motions<Nodes>& after,
                                            Histories) const {
    if (!is_damped()) return 0.0;
    const SpringLine first = compute_line(before);
    const SpringLine last = compute_line(after);
    const double change = last.length - first.length;
    double damping = spring_.damping;
    if (spring_.law && spring_.law->has_rate()) {
        const double rate = 0.5 * (first.length_rate + last.length_rate);
        if (rate == 0.0) return 0.0;
        damping = compute_damper_tension(spring_, 0.5 * (first.length + last.length), rate) / rate;
    }
    return damping * change * change;
}

template <int Nodes>
double SpringElement<Nodes>::strain_energy(const Motions<Nodes>& motions, Histories) const {
    const double length = compute_line(motions).length;
    const double stretch = length - spring_.length;
    const double linear = 0.5 * spring_.stiffness * stretch * stretch;
    return spring_.law ? linear + compute_law_energy(*spring_.law, length) : linear;
}

template class SpringElement<1>;
template class SpringElement<2>;

}  // namespace gxrod
