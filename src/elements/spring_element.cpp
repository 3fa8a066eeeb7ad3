#include "elements/spring_element.hpp"

#include <cassert>

#include "rotation/rotation_map.hpp"

namespace gxrod {

// Legend: u = Λ b arm from a node to its point, spatial; d from point A to point B, ℓ = |d|, e = d/ℓ; N axial
// force; F force on point B that the spring asks for, −F on A (docs/theory/springs.md).

template <int Nodes>
SpringElement<Nodes>::SpringElement(const Spring& spring) : spring_(spring) {
    int i = 0;
    for (std::size_t end = 0; end < 2; ++end) {
        if (spring.ends[end].is_ground()) continue;
        assert(i < Nodes);
        nodes[i] = spring.ends[end].node;
        ends_[i] = end;
        ++i;
    }
    assert(i == Nodes);
}

template <int Nodes>
SpringLine SpringElement<Nodes>::compute_line(const Motions<Nodes>& motions) const {
    std::array<const NodeMotion*, 2> at_ends{nullptr, nullptr};
    for (int i = 0; i < Nodes; ++i) at_ends[ends_[i]] = motions[i];
    return compute_spring_line(spring_, at_ends[0], at_ends[1]);
}

// A spring without a length of its own pulls by k d, also where d has no direction. Of others the force is
// not a number there, and the step is cut.
template <int Nodes>
Vec3 SpringElement<Nodes>::compute_elastic_force(const SpringLine& line) const {
    if (spring_.length == 0.0) return spring_.stiffness * line.d;
    return spring_.stiffness * (line.length - spring_.length) * line.direction;
}

// ∂F/∂d = k e eᵀ + N/ℓ (1 − e eᵀ).
template <int Nodes>
Mat3 SpringElement<Nodes>::compute_stiffness(const SpringLine& line) const {
    if (spring_.length == 0.0) return spring_.stiffness * Mat3::Identity();
    const double across = spring_.stiffness * (line.length - spring_.length) / line.length;
    return across * Mat3::Identity() +
           (spring_.stiffness - across) * line.direction * line.direction.transpose();
}

template <int Nodes>
void SpringElement<Nodes>::add_force(const Motions<Nodes>& motions,
                                     const Vec3& at_B,
                                     NodalVector<Nodes>& force) const {
    for (int i = 0; i < Nodes; ++i) {
        const Vec3 F = sign(i) * at_B;
        force.template segment<3>(6 * i) += F;
        force.template segment<3>(6 * i + 3) += arm(motions, i).cross(F);
    }
}

template <int Nodes>
typename SpringElement<Nodes>::Columns SpringElement<Nodes>::differentiate_line(
    const Motions<Nodes>& motions, const Linearizations<Nodes>& linear) const {
    Columns columns;
    for (int i = 0; i < Nodes; ++i) {
        const double by = sign(i) * linear[i]->placement;
        columns.template middleCols<3>(6 * i) = by * Mat3::Identity();
        columns.template middleCols<3>(6 * i + 3) = -by * spin(arm(motions, i));
    }
    return columns;
}

template <int Nodes>
typename SpringElement<Nodes>::Columns SpringElement<Nodes>::differentiate_rate(
    const Motions<Nodes>& motions, const Linearizations<Nodes>& linear) const {
    Columns columns;
    for (int i = 0; i < Nodes; ++i) {
        const Mat3 spin_u = spin(arm(motions, i));
        const Mat3 turned = linear[i]->placement * spin(motions[i]->omega) * spin_u;
        columns.template middleCols<3>(6 * i) = sign(i) * linear[i]->rate * Mat3::Identity();
        columns.template middleCols<3>(6 * i + 3) = -sign(i) * (spin_u * linear[i]->d_omega + turned);
    }
    return columns;
}

template <int Nodes>
void SpringElement<Nodes>::add_tangent(const Motions<Nodes>& motions,
                                       const Linearizations<Nodes>& linear,
                                       const Vec3& at_B,
                                       const Columns& derivative,
                                       NodalMatrix<Nodes>& tangent) const {
    for (int i = 0; i < Nodes; ++i) {
        const Mat3 spin_u = spin(arm(motions, i));
        tangent.template middleRows<3>(6 * i) += sign(i) * derivative;
        tangent.template middleRows<3>(6 * i + 3) += sign(i) * spin_u * derivative;
        tangent.template block<3, 3>(6 * i + 3, 6 * i + 3) +=
            sign(i) * linear[i]->placement * spin(at_B) * spin_u;
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
    const Columns derivative = compute_stiffness(line) * differentiate_line(motions, linear);
    add_tangent(motions, linear, compute_elastic_force(line), derivative, tangent);
}

template <int Nodes>
void SpringElement<Nodes>::add_damping_force(const Motions<Nodes>& motions,
                                             Histories,
                                             NodalVector<Nodes>& force) const {
    const SpringLine line = compute_line(motions);
    if (spring_.damping == 0.0 || line.length == 0.0) return;
    add_force(motions, spring_.damping * line.length_rate * line.direction, force);
}

// F = c ℓ̇ e, ℓ̇ = e · ḋ: δF = c (e (e · δḋ) + (e ḋᵀ + ℓ̇ 1) δe), δe = (1 − e eᵀ) δd / ℓ.
template <int Nodes>
void SpringElement<Nodes>::add_damping_tangent(const Motions<Nodes>& motions,
                                               Histories,
                                               const Linearizations<Nodes>& linear,
                                               NodalMatrix<Nodes>& tangent) const {
    const SpringLine line = compute_line(motions);
    if (spring_.damping == 0.0 || line.length == 0.0) return;
    const Vec3& e = line.direction;
    const Mat3 across = (Mat3::Identity() - e * e.transpose()) / line.length;
    const Mat3 by_direction = e * line.rate.transpose() + line.length_rate * Mat3::Identity();
    const Columns derivative =
        spring_.damping * (e * (e.transpose() * differentiate_rate(motions, linear)) +
                           by_direction * across * differentiate_line(motions, linear));
    add_tangent(motions, linear, spring_.damping * line.length_rate * e, derivative, tangent);
}

template <int Nodes>
double SpringElement<Nodes>::damping_action(const Motions<Nodes>& before,
                                            const Motions<Nodes>& after,
                                            Histories) const {
    if (spring_.damping == 0.0) return 0.0;
    const double change = compute_line(after).length - compute_line(before).length;
    return spring_.damping * change * change;
}

template <int Nodes>
double SpringElement<Nodes>::strain_energy(const Motions<Nodes>& motions, Histories) const {
    const double stretch = compute_line(motions).length - spring_.length;
    return 0.5 * spring_.stiffness * stretch * stretch;
}

template class SpringElement<1>;
template class SpringElement<2>;

}  // namespace gxrod
