#include "elements/rod/rod_inertia.hpp"

#include <algorithm>

#include "rotation/rotation_map.hpp"

namespace gxrod {

template <int Nodes>
RodInertia<Nodes>::RodInertia(const RodElementGeometry<Nodes>& geometry,
                              const ElementSections<Nodes>& sections)
    : triads_(geometry.triads),
      sections_(sections.at_nodes),
      has_offset_(std::ranges::any_of(sections_, [](const auto& section) { return section->has_offset(); })) {
    mass_.setZero();
    lengths_.setZero();
    const std::array<Vec3, Nodes> positions = geometry.reference().positions;
    const auto rule = compute_gauss_rule<Nodes>();
    for (std::size_t p = 0; p < rule.size(); ++p) {
        const auto [xi, weight] = rule[p];
        const NodeValues<Nodes> shape = compute_shape_functions<Nodes>(xi);
        const NodeValues<Nodes> slope = compute_shape_slopes<Nodes>(xi);
        Vec3 tangent = Vec3::Zero();
        for (int i = 0; i < Nodes; ++i) tangent += slope[i] * positions[i];
        const double ds = weight * tangent.norm();
        mass_ += ds * sections.at_masses[p]->mass * shape * shape.transpose();
        lengths_ += ds * shape;
    }
}

template <int Nodes>
Mat3 RodInertia<Nodes>::compute_rotary_inertia(int node) const {
    const Mat3 R = triads_[node].toRotationMatrix();
    return R * (lengths_[node] * section(node).rotary_inertia) * R.transpose();
}

template <int Nodes>
RotaryInertia<double> RodInertia<Nodes>::turn(int node, const NodeMotion& motion) const {
    return {lengths_[node] * section(node).rotary_inertia, motion.Lambda * triads_[node]};
}

template <int Nodes>
Vec3 RodInertia<Nodes>::compute_spin_momentum(int node, const NodeMotion& motion) const {
    const Mat3 axes = (motion.Lambda * triads_[node]).toRotationMatrix();
    return axes * (lengths_[node] * (section(node).rotary_inertia * (axes.transpose() * motion.omega)));
}

template <int Nodes>
auto RodInertia<Nodes>::compute_offsets(const Motions<Nodes>& motions) const -> Columns3 {
    Columns3 d = Columns3::Zero();
    if (!has_offset()) return d;
    for (int i = 0; i < Nodes; ++i) d.col(i) = motions[i]->Lambda * (triads_[i] * section(i).centre_of_mass);
    return d;
}

template <int Nodes>
auto RodInertia<Nodes>::compute_velocities(const Motions<Nodes>& motions, const Columns3& d) const
    -> Columns3 {
    Columns3 velocities;
    for (int i = 0; i < Nodes; ++i) {
        velocities.col(i) = motions[i]->v + motions[i]->omega.cross(Vec3(d.col(i)));
    }
    return velocities;
}

template <int Nodes>
auto RodInertia<Nodes>::compute_accelerations(const Motions<Nodes>& motions,
                                              const Vec3& gravity,
                                              const Columns3& d) const -> Columns3 {
    Columns3 accelerations;
    for (int i = 0; i < Nodes; ++i) {
        accelerations.col(i) = motions[i]->a - gravity;
        if (!has_offset() || !section(0).has_inertia) continue;
        const Vec3& omega = motions[i]->omega;
        const Vec3 d_i = d.col(i);
        accelerations.col(i) += motions[i]->alpha.cross(d_i) + omega.cross(omega.cross(d_i));
    }
    return accelerations;
}

template <int Nodes>
void RodInertia<Nodes>::add_force(const Motions<Nodes>& motions,
                                  const Vec3& gravity,
                                  NodalVector<Nodes>& force) const {
    add_translational_force(motions, gravity, force);
    if (!section(0).has_inertia) return;
    for (int i = 0; i < Nodes; ++i) {
        force.template segment<3>(6 * i + 3) +=
            turn(i, *motions[i]).compute_moment(motions[i]->omega, motions[i]->alpha);
    }
}

template <int Nodes>
void RodInertia<Nodes>::add_translational_force(const Motions<Nodes>& motions,
                                                const Vec3& gravity,
                                                NodalVector<Nodes>& force) const {
    const Columns3 d = compute_offsets(motions);
    const Columns3 F = compute_accelerations(motions, gravity, d) * mass_;
    for (int i = 0; i < Nodes; ++i) {
        const Vec3 F_i = F.col(i);
        force.template segment<3>(6 * i) += F_i;
        force.template segment<3>(6 * i + 3) += Vec3(d.col(i)).cross(F_i);
    }
}

template <int Nodes>
void RodInertia<Nodes>::add_translational_tangent(const Motions<Nodes>& motions,
                                                  const Vec3& gravity,
                                                  const Linearizations<Nodes>& linearizations,
                                                  NodalMatrix<Nodes>& tangent) const {
    for (int i = 0; i < Nodes; ++i) {
        for (int j = 0; j < Nodes; ++j) {
            tangent.template block<3, 3>(6 * i, 6 * j).diagonal().array() +=
                mass_(i, j) * linearizations[j]->acceleration;
        }
    }
    if (!has_offset()) return;
    const Columns3 d = compute_offsets(motions);
    const Columns3 F = compute_accelerations(motions, gravity, d) * mass_;
    for (int j = 0; j < Nodes; ++j) {
        const NodeLinearization& linearization = *linearizations[j];
        const Mat3 spin_d = spin(d.col(j));
        const Mat3 spin_omega = spin(motions[j]->omega);
        // How the centre of mass's acceleration follows the spin of node j.
        Mat3 by_spin = Mat3::Zero();
        if (section(0).has_inertia) {
            by_spin = -spin_d * linearization.d_alpha -
                      (spin(motions[j]->omega.cross(Vec3(d.col(j)))) + spin_omega * spin_d) *
                          linearization.d_omega -
                      linearization.placement * (spin(motions[j]->alpha) + spin_omega * spin_omega) * spin_d;
        }
        for (int i = 0; i < Nodes; ++i) {
            const Mat3 lever = mass_(i, j) * spin(d.col(i));
            tangent.template block<3, 3>(6 * i, 6 * j + 3) += mass_(i, j) * by_spin;
            tangent.template block<3, 3>(6 * i + 3, 6 * j) += linearization.acceleration * lever;
            tangent.template block<3, 3>(6 * i + 3, 6 * j + 3) += lever * by_spin;
        }
        tangent.template block<3, 3>(6 * j + 3, 6 * j + 3) +=
            linearization.placement * spin(F.col(j)) * spin_d;
    }
}

template <int Nodes>
void RodInertia<Nodes>::add_tangent(const Motions<Nodes>& motions,
                                    const Vec3& gravity,
                                    const Linearizations<Nodes>& linearizations,
                                    NodalMatrix<Nodes>& tangent) const {
    add_translational_tangent(motions, gravity, linearizations, tangent);
    if (!section(0).has_inertia) return;
    for (int i = 0; i < Nodes; ++i) {
        tangent.template block<3, 3>(6 * i + 3, 6 * i + 3) +=
            turn(i, *motions[i])
                .compute_tangent(motions[i]->omega,
                                 motions[i]->alpha,
                                 linearizations[i]->placement,
                                 linearizations[i]->d_omega,
                                 linearizations[i]->d_alpha);
    }
}

template <int Nodes>
void RodInertia<Nodes>::add_translational_damping_force(const Motions<Nodes>& motions,
                                                        NodalVector<Nodes>& force) const {
    const Columns3 d = compute_offsets(motions);
    const Columns3 p = compute_velocities(motions, d) * mass_;
    for (int i = 0; i < Nodes; ++i) {
        const Vec3 p_i = section(0).mass_proportional * p.col(i);
        force.template segment<3>(6 * i) += p_i;
        force.template segment<3>(6 * i + 3) += Vec3(d.col(i)).cross(p_i);
    }
}

template <int Nodes>
void RodInertia<Nodes>::add_damping_force(const Motions<Nodes>& motions, NodalVector<Nodes>& force) const {
    add_translational_damping_force(motions, force);
    for (int i = 0; i < Nodes; ++i) {
        force.template segment<3>(6 * i + 3) +=
            section(0).mass_proportional * compute_spin_momentum(i, *motions[i]);
    }
}

template <int Nodes>
void RodInertia<Nodes>::add_translational_damping_tangent(const Motions<Nodes>& motions,
                                                          const Linearizations<Nodes>& linearizations,
                                                          NodalMatrix<Nodes>& tangent) const {
    const double c = section(0).mass_proportional;
    const Columns3 d = compute_offsets(motions);
    const Columns3 p = compute_velocities(motions, d) * mass_;
    for (int j = 0; j < Nodes; ++j) {
        const NodeLinearization& linearization = *linearizations[j];
        const Mat3 spin_d = spin(d.col(j));
        const Mat3 by_spin =
            -spin_d * linearization.d_omega - linearization.placement * spin(motions[j]->omega) * spin_d;
        for (int i = 0; i < Nodes; ++i) {
            const double m = c * mass_(i, j);
            const Mat3 lever = m * spin(d.col(i));
            tangent.template block<3, 3>(6 * i, 6 * j).diagonal().array() += m * linearization.rate;
            tangent.template block<3, 3>(6 * i, 6 * j + 3) += m * by_spin;
            tangent.template block<3, 3>(6 * i + 3, 6 * j) += linearization.rate * lever;
            tangent.template block<3, 3>(6 * i + 3, 6 * j + 3) += lever * by_spin;
        }
        tangent.template block<3, 3>(6 * j + 3, 6 * j + 3) +=
            (c * linearization.placement) * spin(p.col(j)) * spin_d;
    }
}

template <int Nodes>
void RodInertia<Nodes>::add_damping_tangent(const Motions<Nodes>& motions,
                                            const Linearizations<Nodes>& linearizations,
                                            NodalMatrix<Nodes>& tangent) const {
    add_translational_damping_tangent(motions, linearizations, tangent);
    for (int i = 0; i < Nodes; ++i) {
        tangent.template block<3, 3>(6 * i + 3, 6 * i + 3) +=
            section(0).mass_proportional * turn(i, *motions[i])
                                               .compute_momentum_tangent(motions[i]->omega,
                                                                         linearizations[i]->placement,
                                                                         linearizations[i]->d_omega);
    }
}

template <int Nodes>
double RodInertia<Nodes>::damping_action(const Motions<Nodes>& previous, const Motions<Nodes>& trial) const {
    std::array<NodeMotion, Nodes> before, after;
    Motions<Nodes> at_start, at_end;
    for (int i = 0; i < Nodes; ++i) {
        before[i].Lambda = previous[i]->Lambda;
        after[i].Lambda = trial[i]->Lambda;
        before[i].v = after[i].v = trial[i]->r - previous[i]->r;
        before[i].omega = after[i].omega = trial[i]->theta;
        at_start[i] = &before[i];
        at_end[i] = &after[i];
    }
    // Offsets turn within the step: the mean of both ends.
    return section(0).mass_proportional * (compute_energy(at_start) + compute_energy(at_end));
}

template <int Nodes>
double RodInertia<Nodes>::kinetic_energy(const Motions<Nodes>& motions) const {
    return section(0).has_inertia ? compute_energy(motions) : 0.0;
}

template <int Nodes>
double RodInertia<Nodes>::compute_energy(const Motions<Nodes>& motions) const {
    const Columns3 v = compute_velocities(motions, compute_offsets(motions));
    double energy = 0.5 * (v * mass_).cwiseProduct(v).sum();
    for (int i = 0; i < Nodes; ++i)
        energy += 0.5 * motions[i]->omega.dot(compute_spin_momentum(i, *motions[i]));
    return energy;
}

template <int Nodes>
double RodInertia<Nodes>::gravity_potential(const Motions<Nodes>& motions, const Vec3& gravity) const {
    const Columns3 d = compute_offsets(motions);
    double potential = 0.0;
    for (int i = 0; i < Nodes; ++i) {
        potential -= mass_.row(i).sum() * gravity.dot(motions[i]->r + d.col(i));
    }
    return potential;
}

template <int Nodes>
Momentum RodInertia<Nodes>::momentum(const Motions<Nodes>& motions) const {
    if (!section(0).has_inertia) return {};
    const Columns3 d = compute_offsets(motions);
    const Columns3 p = compute_velocities(motions, d) * mass_;
    Momentum total;
    for (int i = 0; i < Nodes; ++i) {
        const Vec3 p_i = p.col(i);
        total.linear += p_i;
        total.angular += (motions[i]->r + d.col(i)).cross(p_i) + compute_spin_momentum(i, *motions[i]);
    }
    return total;
}

template class RodInertia<2>;
template class RodInertia<3>;
template class RodInertia<4>;
template class RodInertia<5>;

}  // namespace gxrod
