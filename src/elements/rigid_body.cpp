#include "elements/rigid_body.hpp"

namespace gxrod {

RigidBody::RigidBody(const Body& body)
    : nodes{body.node},
      inertia_(compute_rigid_inertia(body.mass, body.inertia, body.centre_of_mass, body.attitude)) {}

void RigidBody::add_inertial_force(const Motions<1>& motions,
                                   const Vec3& gravity,
                                   NodalVector<1>& force) const {
    force += compute_inertial_force(inertia_, *motions[0], gravity);
}

void RigidBody::add_inertial_tangent(const Motions<1>& motions,
                                     const Vec3& gravity,
                                     const Linearizations<1>& linearizations,
                                     NodalMatrix<1>& tangent) const {
    tangent += compute_inertial_tangent(inertia_, *motions[0], *linearizations[0], gravity);
}

double RigidBody::kinetic_energy(const Motions<1>& motions) const {
    return compute_kinetic_energy(inertia_, *motions[0]);
}

double RigidBody::gravity_potential(const Motions<1>& motions, const Vec3& gravity) const {
    return compute_gravity_potential(inertia_, *motions[0], gravity);
}

Momentum RigidBody::momentum(const Motions<1>& motions) const {
    return compute_momentum(inertia_, *motions[0]);
}

}  // namespace gxrod
