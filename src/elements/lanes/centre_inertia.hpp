#pragma once

#include "elements/lanes/general_rows.hpp"
#include "elements/lanes/lane_products.hpp"
#include "rotation/cross_products.hpp"

namespace gxrod {

// Inertia and mass-proportional damping of the centres of mass of a rod's sections, which may lie off the
// nodes (docs/theory/rods.md, (R23)–(R27)); without the part lumped at the nodes.
//
// Legend: d from a node to its centre of mass, w the centre's velocity, m masses ∫ρA N_I N_J ds. All are
// spatial.
template <int Nodes, class Real>
class CentreInertia {
  public:
    using Vec3 = Eigen::Matrix<Real, 3, 1>;
    using Mat3 = Eigen::Matrix<Real, 3, 3>;
    using Mass = Eigen::Matrix<Real, Nodes, Nodes>;
    using Vectors = std::array<Vec3, Nodes>;
    using Tangent = Eigen::Matrix<Real, 6 * Nodes, 6 * Nodes>;

    using Forces = NodeForces<Nodes, Real>;

    // All arguments must outlive this; `axes` are the section axes at the nodes.
    CentreInertia(const GeneralSection<Nodes, Real>& section,
                  const Mass& mass,
                  const std::array<Eigen::Quaternion<Real>, Nodes>& axes,
                  const NodeRates<Nodes, Real>& rates)
        : section_(section), mass_(mass), rates_(rates) {
        for (int i = 0; i < Nodes; ++i) {
            if (section.has_offset) {
                d_[i] = axes[i] * section.centre_of_mass[i];
            } else {
                d_[i].setConstant(Real(0.0));
            }
        }
    }

    Forces compute_inertial_forces() const { return make_forces(compute_accelerations()); }
    Forces compute_damping_forces() const { return make_forces(compute_damping_accelerations()); }
    // Adds the tangent of both forces.
    void add_tangent(const NodeLinearizations<Nodes, Real>& linearizations, Tangent& tangent) const;

  private:
    Vectors compute_accelerations() const {
        if (!section_.has_offset) return rates_.a;
        Vectors accelerations;
        for (int i = 0; i < Nodes; ++i) {
            const Vec3& omega = rates_.omega[i];
            accelerations[i] = rates_.a[i] + rates_.alpha[i].cross(d_[i]) + omega.cross(omega.cross(d_[i]));
        }
        return accelerations;
    }
    // Computes c w: the accelerations whose inertia equals the force of damping.
    Vectors compute_damping_accelerations() const {
        Vectors accelerations;
        for (int i = 0; i < Nodes; ++i) {
            const Vec3 w = rates_.v[i] + rates_.omega[i].cross(d_[i]);
            accelerations[i] = section_.mass_proportional * w;
        }
        return accelerations;
    }
    Vec3 compute_force(int node, const Vectors& accelerations) const {
        Vec3 force = mass_(node, 0) * accelerations[0];
        for (int j = 1; j < Nodes; ++j) force += mass_(node, j) * accelerations[j];
        return force;
    }
    Forces make_forces(const Vectors& accelerations) const {
        Forces forces;
        for (int i = 0; i < Nodes; ++i) {
            forces.n[i] = compute_force(i, accelerations);
            forces.m[i] = d_[i].cross(forces.n[i]);
        }
        return forces;
    }
    // Computes the derivative of a centre's acceleration, and of c w, by the spin of its node.
    Mat3 compute_by_spin(int node, const NodeLinearizations<Nodes, Real>& linearizations) const;

    const GeneralSection<Nodes, Real>& section_;
    const Mass& mass_;
    const NodeRates<Nodes, Real>& rates_;
    Vectors d_;
};

template <int Nodes, class Real>
auto CentreInertia<Nodes, Real>::compute_by_spin(int node,
                                                 const NodeLinearizations<Nodes, Real>& linearizations) const
    -> Mat3 {
    const Vec3& d = d_[node];
    const Vec3& omega = rates_.omega[node];
    const Real& placement = linearizations.placement[node];
    const Real& c = section_.mass_proportional;
    const Mat3 omega_d = cross_columns<Real>(omega, cross_matrix(d));  // [ω]× [d]×
    const Mat3 by_placement = cross_columns<Real>(rates_.alpha[node], cross_matrix(d)) +
                              cross_columns(omega, omega_d) + c * omega_d;
    const Mat3 by_omega = cross_matrix<Real>(omega.cross(d) + c * d) + omega_d;
    return -cross_columns(d, linearizations.d_alpha[node]) -
           multiply(by_omega, linearizations.d_omega[node]) - placement * by_placement;
}

template <int Nodes, class Real>
void CentreInertia<Nodes, Real>::add_tangent(const NodeLinearizations<Nodes, Real>& linearizations,
                                             Tangent& tangent) const {
    Vectors accelerations = compute_accelerations();
    if (section_.has_offset && section_.has_mass_damping) {
        const Vectors of_damping = compute_damping_accelerations();
        for (int i = 0; i < Nodes; ++i) accelerations[i] += of_damping[i];
    }
    for (int j = 0; j < Nodes; ++j) {
        const Real by_displacement =
            linearizations.acceleration[j] + section_.mass_proportional * linearizations.rate[j];
        for (int i = 0; i < Nodes; ++i) {
            tangent.template block<3, 3>(6 * i, 6 * j).diagonal().array() += mass_(i, j) * by_displacement;
        }
        if (!section_.has_offset) continue;
        const Mat3 by_spin = compute_by_spin(j, linearizations);
        for (int i = 0; i < Nodes; ++i) {
            const Mat3 n = mass_(i, j) * by_spin;
            add_block(n, 6 * i, 6 * j + 3, tangent);
            add_block(cross_matrix<Real>((mass_(i, j) * by_displacement) * d_[i]), 6 * i + 3, 6 * j, tangent);
            add_block(cross_columns(d_[i], n), 6 * i + 3, 6 * j + 3, tangent);
        }
        const Vec3 force = linearizations.placement[j] * compute_force(j, accelerations);
        add_block(cross_columns<Real>(force, cross_matrix(d_[j])), 6 * j + 3, 6 * j + 3, tangent);
    }
}

}  // namespace gxrod
