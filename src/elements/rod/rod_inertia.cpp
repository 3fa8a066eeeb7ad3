#include "elements/rod/rod_inertia.hpp"

namespace gxrod {

template <int Nodes>
RodInertia<Nodes>::RodInertia(const std::array<Vec3, Nodes>& positions,
                              const std::array<Quat, Nodes>& triads,
                              const Section& section) {
    mass_.setZero();
    NodeValues<Nodes> length = NodeValues<Nodes>::Zero();  // ∫ N_I ds
    for (const auto& [xi, weight] : compute_gauss_rule<Nodes>()) {
        const NodeValues<Nodes> shape = compute_shape_functions<Nodes>(xi);
        const NodeValues<Nodes> slope = compute_shape_slopes<Nodes>(xi);
        Vec3 tangent = Vec3::Zero();
        for (int i = 0; i < Nodes; ++i) tangent += slope[i] * positions[i];
        const double ds = weight * tangent.norm();
        mass_ += ds * section.mass(0, 0) * shape * shape.transpose();
        length += ds * shape;
    }
    for (int i = 0; i < Nodes; ++i) {
        const Mat3 rotary = length[i] * section.mass.bottomRightCorner<3, 3>();
        nodal_[i] = compute_rigid_inertia(0.0, rotary, Vec3::Zero(), triads[i]);
    }
}

template <int Nodes>
void RodInertia<Nodes>::add_force(const Motions<Nodes>& motions,
                                  const Vec3& gravity,
                                  NodalVector<Nodes>& force) const {
    for (int i = 0; i < Nodes; ++i) {
        for (int j = 0; j < Nodes; ++j) {
            force.template segment<3>(6 * i) += mass_(i, j) * (motions[j]->a - gravity);
        }
        force.template segment<6>(6 * i) += compute_inertial_force(nodal_[i], *motions[i], gravity);
    }
}

template <int Nodes>
void RodInertia<Nodes>::add_tangent(const Motions<Nodes>& motions,
                                    const Vec3& gravity,
                                    const Linearizations<Nodes>& linearizations,
                                    NodalMatrix<Nodes>& tangent) const {
    for (int i = 0; i < Nodes; ++i) {
        for (int j = 0; j < Nodes; ++j) {
            tangent.template block<3, 3>(6 * i, 6 * j).diagonal().array() +=
                mass_(i, j) * linearizations[j]->acceleration;
        }
        tangent.template block<6, 6>(6 * i, 6 * i) +=
            compute_inertial_tangent(nodal_[i], *motions[i], *linearizations[i], gravity);
    }
}

template <int Nodes>
double RodInertia<Nodes>::kinetic_energy(const Motions<Nodes>& motions) const {
    double energy = 0.0;
    for (int i = 0; i < Nodes; ++i) {
        for (int j = 0; j < Nodes; ++j) energy += 0.5 * mass_(i, j) * motions[i]->v.dot(motions[j]->v);
        energy += compute_kinetic_energy(nodal_[i], *motions[i]);
    }
    return energy;
}

template <int Nodes>
double RodInertia<Nodes>::gravity_potential(const Motions<Nodes>& motions, const Vec3& gravity) const {
    double potential = 0.0;
    for (int i = 0; i < Nodes; ++i) {
        potential -= mass_.row(i).sum() * gravity.dot(motions[i]->r);
        potential += compute_gravity_potential(nodal_[i], *motions[i], gravity);
    }
    return potential;
}

template <int Nodes>
Momentum RodInertia<Nodes>::momentum(const Motions<Nodes>& motions) const {
    Momentum total;
    for (int i = 0; i < Nodes; ++i) {
        Vec3 linear = Vec3::Zero();
        for (int j = 0; j < Nodes; ++j) linear += mass_(i, j) * motions[j]->v;
        const Momentum rotary = compute_momentum(nodal_[i], *motions[i]);
        total.linear += linear + rotary.linear;
        total.angular += motions[i]->r.cross(linear) + rotary.angular;
    }
    return total;
}

template class RodInertia<2>;

}  // namespace gxrod
