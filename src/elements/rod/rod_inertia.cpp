#include "elements/rod/rod_inertia.hpp"

#include "elements/rod/shape_functions.hpp"
#include "rotation/rotation_map.hpp"

namespace gxrod {

namespace {

// From the section's node to its centre of mass, section axes: the mass matrix has −ρA [d]× for its coupling.
Vec3 compute_offset(const Section& section) {
    const double rho_A = section.mass(0, 0);
    if (rho_A == 0.0) return Vec3::Zero();
    return -axial(section.mass.topRightCorner<3, 3>()) / rho_A;
}

// About the centre of mass, section axes.
Mat3 compute_rotary_inertia(const Section& section, const Vec3& offset) {
    const Mat3 spin_d = spin(offset);
    return section.mass.bottomRightCorner<3, 3>() + section.mass(0, 0) * spin_d * spin_d;
}

}  // namespace

template <int Nodes>
RodInertia<Nodes>::RodInertia(const RodElementGeometry<Nodes>& geometry, const Section& section)
    : mass_proportional_(section.mass_proportional) {
    mass_.setZero();
    NodeValues<Nodes> length = NodeValues<Nodes>::Zero();  // ∫ N_I ds
    for (const auto& [xi, weight] : compute_gauss_rule<Nodes>()) {
        const NodeValues<Nodes> shape = compute_shape_functions<Nodes>(xi);
        const NodeValues<Nodes> slope = compute_shape_slopes<Nodes>(xi);
        Vec3 tangent = Vec3::Zero();
        for (int i = 0; i < Nodes; ++i) tangent += slope[i] * geometry.positions[i];
        const double ds = weight * tangent.norm();
        mass_ += ds * section.mass(0, 0) * shape * shape.transpose();
        length += ds * shape;
    }
    const Vec3 offset = compute_offset(section);
    has_offset_ = !offset.isZero(0.0);
    for (int i = 0; i < Nodes; ++i) {
        const Mat3 rotary = length[i] * compute_rotary_inertia(section, offset);
        rotary_[i] = compute_rigid_inertia(0.0, rotary, Vec3::Zero(), geometry.triads[i]);
        offsets_.col(i) = geometry.triads[i] * offset;
    }
}

template <int Nodes>
auto RodInertia<Nodes>::compute_offsets(const Motions<Nodes>& motions) const -> Columns3 {
    Columns3 d = Columns3::Zero();
    if (!has_offset_) return d;
    for (int i = 0; i < Nodes; ++i) d.col(i) = motions[i]->Lambda * Vec3(offsets_.col(i));
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
        if (!has_offset_) continue;
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
    for (int i = 0; i < Nodes; ++i) {
        force.template segment<3>(6 * i + 3) +=
            compute_inertial_force(rotary_[i], *motions[i], gravity).template tail<3>();
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
void RodInertia<Nodes>::add_translational_tangent(const Linearizations<Nodes>& linearizations,
                                                  NodalMatrix<Nodes>& tangent) const {
    for (int i = 0; i < Nodes; ++i) {
        for (int j = 0; j < Nodes; ++j) {
            tangent.template block<3, 3>(6 * i, 6 * j).diagonal().array() +=
                mass_(i, j) * linearizations[j]->acceleration;
        }
    }
}

template <int Nodes>
void RodInertia<Nodes>::add_tangent(const Motions<Nodes>& motions,
                                    const Vec3& gravity,
                                    const Linearizations<Nodes>& linearizations,
                                    NodalMatrix<Nodes>& tangent) const {
    add_translational_tangent(linearizations, tangent);
    for (int i = 0; i < Nodes; ++i) {
        tangent.template block<6, 6>(6 * i, 6 * i) +=
            compute_inertial_tangent(rotary_[i], *motions[i], *linearizations[i], gravity);
    }
    if (!has_offset_) return;
    const Columns3 d = compute_offsets(motions);
    const Columns3 F = compute_accelerations(motions, gravity, d) * mass_;
    for (int j = 0; j < Nodes; ++j) {
        const NodeLinearization& linearization = *linearizations[j];
        const Mat3 spin_d = spin(d.col(j));
        const Mat3 spin_omega = spin(motions[j]->omega);
        // How the centre of mass's acceleration follows the spin of node j.
        const Mat3 by_spin =
            -spin_d * linearization.d_alpha -
            (spin(motions[j]->omega.cross(Vec3(d.col(j)))) + spin_omega * spin_d) * linearization.d_omega -
            linearization.placement * (spin(motions[j]->alpha) + spin_omega * spin_omega) * spin_d;
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
void RodInertia<Nodes>::add_damping_force(const Motions<Nodes>& motions, NodalVector<Nodes>& force) const {
    const Columns3 d = compute_offsets(motions);
    const Columns3 p = compute_velocities(motions, d) * mass_;
    for (int i = 0; i < Nodes; ++i) {
        const Vec3 p_i = p.col(i);
        force.template segment<3>(6 * i) += mass_proportional_ * p_i;
        force.template segment<3>(6 * i + 3) +=
            mass_proportional_ *
            (Vec3(d.col(i)).cross(p_i) + compute_momentum(rotary_[i], *motions[i]).angular);
    }
}

template <int Nodes>
void RodInertia<Nodes>::add_damping_tangent(const Motions<Nodes>& motions,
                                            const Linearizations<Nodes>& linearizations,
                                            NodalMatrix<Nodes>& tangent) const {
    const double c = mass_proportional_;
    const Columns3 d = compute_offsets(motions);
    const Columns3 p = compute_velocities(motions, d) * mass_;
    for (int j = 0; j < Nodes; ++j) {
        const NodeLinearization& linearization = *linearizations[j];
        const Vec3& omega = motions[j]->omega;
        const Mat3 spin_d = spin(d.col(j));
        const Mat3 by_spin = -spin_d * linearization.d_omega - linearization.placement * spin(omega) * spin_d;
        for (int i = 0; i < Nodes; ++i) {
            const double m = c * mass_(i, j);
            const Mat3 lever = m * spin(d.col(i));
            tangent.template block<3, 3>(6 * i, 6 * j).diagonal().array() += m * linearization.rate;
            tangent.template block<3, 3>(6 * i, 6 * j + 3) += m * by_spin;
            tangent.template block<3, 3>(6 * i + 3, 6 * j) += linearization.rate * lever;
            tangent.template block<3, 3>(6 * i + 3, 6 * j + 3) += lever * by_spin;
        }
        const Mat3 Lambda = motions[j]->Lambda.toRotationMatrix();
        const Mat3 J = Lambda * rotary_[j].inertia * Lambda.transpose();
        tangent.template block<3, 3>(6 * j + 3, 6 * j + 3) +=
            c * (J * linearization.d_omega +
                 linearization.placement * (J * spin(omega) - spin(J * omega) + spin(p.col(j)) * spin_d));
    }
}

template <int Nodes>
double RodInertia<Nodes>::kinetic_energy(const Motions<Nodes>& motions) const {
    const Columns3 v = compute_velocities(motions, compute_offsets(motions));
    double energy = 0.5 * (v * mass_).cwiseProduct(v).sum();
    for (int i = 0; i < Nodes; ++i) energy += compute_kinetic_energy(rotary_[i], *motions[i]);
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
    const Columns3 d = compute_offsets(motions);
    const Columns3 p = compute_velocities(motions, d) * mass_;
    Momentum total;
    for (int i = 0; i < Nodes; ++i) {
        const Vec3 p_i = p.col(i);
        total.linear += p_i;
        total.angular +=
            (motions[i]->r + d.col(i)).cross(p_i) + compute_momentum(rotary_[i], *motions[i]).angular;
    }
    return total;
}

template class RodInertia<2>;
template class RodInertia<3>;
template class RodInertia<4>;
template class RodInertia<5>;

}  // namespace gxrod
