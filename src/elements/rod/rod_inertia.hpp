#pragma once

#include "elements/element.hpp"
#include "elements/rod/shape_functions.hpp"
#include "model/model.hpp"

namespace gxrod {

// The inertia of a rod element: mass integrated exactly along the element (Nodes Gauss points), rotary
// inertia lumped to the nodes with the weights of nodal quadrature. Each node is then a small rigid body, so
// that the semi-discrete balances of momentum, angular momentum and energy are exact.
template <int Nodes>
class RodInertia {
  public:
    RodInertia(const std::array<Vec3, Nodes>& positions,
               const std::array<Quat, Nodes>& triads,
               const Section& section);

    void add_force(const Motions<Nodes>& motions, const Vec3& gravity, NodalVector<Nodes>& force) const;
    void add_tangent(const Motions<Nodes>& motions,
                     const Vec3& gravity,
                     const Linearizations<Nodes>& linearizations,
                     NodalMatrix<Nodes>& tangent) const;
    double kinetic_energy(const Motions<Nodes>& motions) const;
    double gravity_potential(const Motions<Nodes>& motions, const Vec3& gravity) const;
    Momentum momentum(const Motions<Nodes>& motions) const;

  private:
    Eigen::Matrix<double, Nodes, Nodes> mass_;  // ∫ ρA N_I N_J ds
    std::array<RigidInertia, Nodes> nodal_;     // rotary inertia; no mass
};

extern template class RodInertia<2>;

}  // namespace gxrod
