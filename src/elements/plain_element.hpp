#pragma once

#include "elements/element.hpp"

namespace gxrod {

// An element without section, memory, inertia, stiffness and damping: elements of few points override what
// they have and inherit the rest.
template <int Nodes>
class PlainElement {
  public:
    static constexpr int node_count = Nodes;
    static constexpr int history_count = 0;
    static constexpr int point_count = 0;
    static constexpr bool has_section = false;
    std::array<int, Nodes> nodes{};

    void add_internal_force(const Motions<Nodes>&, Histories, NodalVector<Nodes>&) const {}
    void add_internal_tangent(const Motions<Nodes>&,
                              Histories,
                              const Linearizations<Nodes>&,
                              NodalMatrix<Nodes>&) const {}
    void add_mixed_tangent(const Motions<Nodes>&,
                           Histories,
                           Resultants,
                           const Linearizations<Nodes>&,
                           NodalMatrix<Nodes>&) const {}
    void advance_resultants(const Motions<Nodes>&,
                            Histories,
                            const NodalVector<Nodes>&,
                            std::span<Vec6>) const {}
    void add_inertial_force(const Motions<Nodes>&, const Vec3&, NodalVector<Nodes>&) const {}
    void add_inertial_tangent(const Motions<Nodes>&,
                              const Vec3&,
                              const Linearizations<Nodes>&,
                              NodalMatrix<Nodes>&) const {}
    bool is_damped() const { return false; }
    void add_damping_force(const Motions<Nodes>&, Histories, NodalVector<Nodes>&) const {}
    void add_damping_tangent(const Motions<Nodes>&,
                             Histories,
                             const Linearizations<Nodes>&,
                             NodalMatrix<Nodes>&) const {}
    double damping_action(const Motions<Nodes>&, const Motions<Nodes>&, Histories) const { return 0.0; }
    void start(std::span<SectionHistory>) const {}
    void commit(const Motions<Nodes>&, Histories, WritableHistories) const {}
    int memory_count() const { return 0; }
    void add_driven_points(const Motions<Nodes>&, Histories, std::vector<DrivenPoint>&) const {}
    bool has_law() const { return false; }
    double dissipated_energy(const Motions<Nodes>&, Histories) const { return 0.0; }
    double largest_relative_rotation(const Motions<Nodes>&) const { return 0.0; }
    double strain_energy(const Motions<Nodes>&, Histories) const { return 0.0; }
    double kinetic_energy(const Motions<Nodes>&) const { return 0.0; }
    double gravity_potential(const Motions<Nodes>&, const Vec3&) const { return 0.0; }
    Momentum momentum(const Motions<Nodes>&) const { return {}; }
};

}  // namespace gxrod
