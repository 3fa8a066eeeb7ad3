#pragma once

#include "elements/plain_element.hpp"
#include "model/model.hpp"

namespace gxrod {

// A rigid body on one node: inertia and gravity only (Rubin 2007, section 5).
class RigidBody : public PlainElement<1> {
  public:
    // A body without inertia only has weight.
    explicit RigidBody(const Body& body, bool has_inertia = true);

    void add_inertial_force(const Motions<1>& motions, const Vec3& gravity, NodalVector<1>& force) const;
    void add_inertial_tangent(const Motions<1>& motions,
                              const Vec3& gravity,
                              const Linearizations<1>& linearizations,
                              NodalMatrix<1>& tangent) const;
    double kinetic_energy(const Motions<1>& motions) const;
    double gravity_potential(const Motions<1>& motions, const Vec3& gravity) const;
    Momentum momentum(const Motions<1>& motions) const;

  private:
    NodeMotion take_motion(const NodeMotion& motion) const;

    RigidInertia inertia_;
    bool has_inertia_;
};

static_assert(Element<RigidBody>);

}  // namespace gxrod
