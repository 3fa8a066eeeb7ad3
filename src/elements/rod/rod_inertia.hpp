#pragma once

#include "elements/element.hpp"
#include "elements/rod/rod_geometry.hpp"
#include "elements/rod/rod_section.hpp"
#include "elements/rotary_inertia.hpp"
#include "numerics/gauss_legendre.hpp"
#include "numerics/lagrange.hpp"

namespace gxrod {

// The inertia of a rod element. Each node moves the centre of mass of its section, r_I + d_I, like a rigid
// body; between the nodes these points are interpolated and their mass is integrated (Nodes Gauss points).
// Rotary inertia about them is lumped at the nodes with the weights of nodal quadrature. The kinetic energy
// is then positive for every offset, and the semi-discrete balances of momentum, angular momentum and energy
// are exact (docs/theory/rods.md, (R23)–(R27)).
template <int Nodes>
class RodInertia {
  public:
    RodInertia(const RodElementGeometry<Nodes>& geometry, const ElementSections<Nodes>& sections);

    void add_force(const Motions<Nodes>& motions, const Vec3& gravity, NodalVector<Nodes>& force) const;
    void add_tangent(const Motions<Nodes>& motions,
                     const Vec3& gravity,
                     const Linearizations<Nodes>& linearizations,
                     NodalMatrix<Nodes>& tangent) const;

    // Damping: forces and couples that are mass_proportional times the momenta.
    bool is_damped() const { return section(0).mass_proportional > 0.0; }
    void add_damping_force(const Motions<Nodes>& motions, NodalVector<Nodes>& force) const;
    void add_damping_tangent(const Motions<Nodes>& motions,
                             const Linearizations<Nodes>& linearizations,
                             NodalMatrix<Nodes>& tangent) const;
    // Computes mass_proportional × twice the kinetic energy with the step's displacements and rotation
    // vectors as rates.
    double damping_action(const Motions<Nodes>& previous, const Motions<Nodes>& trial) const;

    // These add the share of the centres of mass, without rotary inertia.
    void add_translational_force(const Motions<Nodes>& motions,
                                 const Vec3& gravity,
                                 NodalVector<Nodes>& force) const;
    void add_translational_tangent(const Motions<Nodes>& motions,
                                   const Vec3& gravity,
                                   const Linearizations<Nodes>& linearizations,
                                   NodalMatrix<Nodes>& tangent) const;
    void add_translational_damping_force(const Motions<Nodes>& motions, NodalVector<Nodes>& force) const;
    void add_translational_damping_tangent(const Motions<Nodes>& motions,
                                           const Linearizations<Nodes>& linearizations,
                                           NodalMatrix<Nodes>& tangent) const;

    // The masses ∫ρA N_I N_J ds.
    const Eigen::Matrix<double, Nodes, Nodes>& mass() const { return mass_; }
    bool has_offset() const { return has_offset_; }
    const RodSection& section(int node) const { return *sections_[node]; }
    // Computes the rotary inertia lumped at a node, in the global axes of t = 0.
    Mat3 compute_rotary_inertia(int node) const;
    // The section axes of the nodes at t = 0.
    const std::array<Quat, Nodes>& triads() const { return triads_; }

    double kinetic_energy(const Motions<Nodes>& motions) const;
    double gravity_potential(const Motions<Nodes>& motions, const Vec3& gravity) const;
    Momentum momentum(const Motions<Nodes>& motions) const;

  private:
    using Columns3 = Eigen::Matrix<double, 3, Nodes>;

    // Computes the offset of each node's centre of mass, spatial.
    Columns3 compute_offsets(const Motions<Nodes>& motions) const;
    // Computes velocities of the centres of mass.
    Columns3 compute_velocities(const Motions<Nodes>& motions, const Columns3& d) const;
    // Computes accelerations of the centres of mass less gravity.
    Columns3 compute_accelerations(const Motions<Nodes>& motions,
                                   const Vec3& gravity,
                                   const Columns3& d) const;

    // Computes half the mass times the squared velocities.
    double compute_energy(const Motions<Nodes>& motions) const;
    // Returns the present rotary inertia lumped at a node.
    RotaryInertia<double> turn(int node, const NodeMotion& motion) const;
    // Computes its J ω directly, without J.
    Vec3 compute_spin_momentum(int node, const NodeMotion& motion) const;

    std::array<Quat, Nodes> triads_;
    Eigen::Matrix<double, Nodes, Nodes> mass_;
    NodeValues<Nodes> lengths_;                     // ∫ N_I ds
    std::array<SharedRodSection, Nodes> sections_;  // at the nodes
    bool has_offset_;
};

extern template class RodInertia<2>;
extern template class RodInertia<3>;
extern template class RodInertia<4>;
extern template class RodInertia<5>;

}  // namespace gxrod
