#include "elements/rigid_body.hpp"

namespace gxrod {

RigidBody::RigidBody(const Body& body, bool has_inertia)
    : inertia_(compute_rigid_inertia(body.mass, body.inertia, body.centre_of_mass, body.attitude)),
      has_inertia_(has_inertia) {
    nodes = {body.node};
}

NodeMotion RigidBody::take_motion(const NodeMotion& motion) const {
    if (has_inertia_) return motion;
    NodeMotion still;
    still.r = motion.r;
    still.Lambda = motion.Lambda;
    return still;
}

void RigidBody::add_inertial_force(const Motions<1>& motions,
                                   const Vec3& gravity,
                                   NodalVector<1>& force) const {
    force += compute_inertial_force(inertia_, take_motion(*motions[0]), gravity);
}

void RigidBody::add_inertial_tangent(const Motions<1>& motions,
                                     const Vec3& gravity,
                                     const Linearizations<1>& linearizations,
                                     NodalMatrix<1>& tangent) const {
    tangent += compute_inertial_tangent(inertia_, take_motion(*motions[0]), *linearizations[0], gravity);
}

double RigidBody::kinetic_energy(const Motions<1>& motions) const {
    return compute_kinetic_energy(inertia_, take_motion(*motions[0]));
}

double RigidBody::gravity_potential(const Motions<1>& motions, const Vec3& gravity) const {
    return compute_gravity_potential(inertia_, *motions[0], gravity);
}

Momentum RigidBody::momentum(const Motions<1>& motions) const {
    return compute_momentum(inertia_, take_motion(*motions[0]));
}

}  // namespace gxrod
