#pragma once

#include "elements/element.hpp"
#include "model/model.hpp"

namespace gxrod {

// A rigid body on one node: inertia and gravity only (Rubin 2007, section 5).
class RigidBody {
  public:
    static constexpr int node_count = 1;
    static constexpr int history_count = 0;
    static constexpr int point_count = 0;
    static constexpr bool has_section = false;
    std::array<int, 1> nodes;

    // Without inertia it only has weight.
    explicit RigidBody(const Body& body, bool has_inertia = true);

    void add_internal_force(const Motions<1>&, Histories, NodalVector<1>&) const {}
    void add_internal_tangent(const Motions<1>&, Histories, const Linearizations<1>&, NodalMatrix<1>&) const {
    }
    void add_mixed_tangent(
        const Motions<1>&, Histories, Resultants, const Linearizations<1>&, NodalMatrix<1>&) const {}
    void advance_resultants(const Motions<1>&, Histories, const NodalVector<1>&, std::span<Vec6>) const {}
    void add_inertial_force(const Motions<1>& motions, const Vec3& gravity, NodalVector<1>& force) const;
    void add_inertial_tangent(const Motions<1>& motions,
                              const Vec3& gravity,
                              const Linearizations<1>& linearizations,
                              NodalMatrix<1>& tangent) const;
    bool is_damped() const { return false; }
    void add_damping_force(const Motions<1>&, Histories, NodalVector<1>&) const {}
    void add_damping_tangent(const Motions<1>&, Histories, const Linearizations<1>&, NodalMatrix<1>&) const {}
    double damping_action(const Motions<1>&, const Motions<1>&, Histories) const { return 0.0; }
    void start(std::span<SectionHistory>) const {}
    void commit(const Motions<1>&, std::span<SectionHistory>) const {}
    double largest_relative_rotation(const Motions<1>&) const { return 0.0; }
    double strain_energy(const Motions<1>&, Histories) const { return 0.0; }
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
