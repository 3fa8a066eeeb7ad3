#pragma once

#include "elements/element.hpp"
#include "elements/rod/interpolated_rod.hpp"
#include "elements/rod/objective_map.hpp"
#include "elements/rod/rod_geometry.hpp"
#include "elements/rod/rod_inertia.hpp"
#include "elements/rod/simo_map.hpp"
#include "elements/rod/two_node_rod.hpp"
#include "state/values/point_values.hpp"
#include "state/values/section_values.hpp"

namespace gxrod {

// A geometrically exact rod element that interpolates positions and rotation vectors; `Map` chooses the
// attitude from which rotation vectors are measured.
template <int Nodes, class Map>
class RodElement {
  public:
    static constexpr int node_count = Nodes;
    static constexpr int history_count = Map::history_count;
    static constexpr int point_count = InterpolatedRod<Nodes>::point_count;
    static constexpr bool has_section = true;
    std::array<int, Nodes> nodes;

    RodElement(const RodElementGeometry<Nodes>& geometry, const ElementSections<Nodes>& sections);
    // Makes an element with a section of its own.
    RodElement(const RodElementGeometry<Nodes>& geometry, const Section& section)
        : RodElement(geometry, ElementSections<Nodes>(std::make_shared<const RodSection>(section))) {}

    const RodInertia<Nodes>& inertia() const { return inertia_; }
    const InterpolatedRod<Nodes>& interpolated_rod() const { return rod_; }
    const std::array<Quat, Nodes>& triads() const { return inertia_.triads(); }

    void add_internal_force(const Motions<Nodes>& motions,
                            Histories histories,
                            NodalVector<Nodes>& force) const;
    void add_internal_tangent(const Motions<Nodes>& motions,
                              Histories histories,
                              const Linearizations<Nodes>& linearizations,
                              NodalMatrix<Nodes>& tangent) const;
    // Adds the tangent with independent `resultants` in place of C E in the terms that turn with the motion.
    void add_mixed_tangent(const Motions<Nodes>& motions,
                           Histories histories,
                           Resultants resultants,
                           const Linearizations<Nodes>& linearizations,
                           NodalMatrix<Nodes>& tangent) const;
    // Advances the resultants by the increment (δr, δφ) to first order: S + D δE.
    void advance_resultants(const Motions<Nodes>& motions,
                            Histories histories,
                            const NodalVector<Nodes>& increment,
                            std::span<Vec6> resultants) const;
    // Computes ∫ δE (D δE) ds, component by component, for the first-order strains δE of the increment (δr,
    // δφ).
    Vec6 compute_strain_work(const Motions<Nodes>& motions,
                             Histories histories,
                             const NodalVector<Nodes>& increment) const;
    void add_inertial_force(const Motions<Nodes>& motions,
                            const Vec3& gravity,
                            NodalVector<Nodes>& force) const;
    void add_inertial_tangent(const Motions<Nodes>& motions,
                              const Vec3& gravity,
                              const Linearizations<Nodes>& linearizations,
                              NodalMatrix<Nodes>& tangent) const;

    bool is_damped() const { return rod_.is_damped() || inertia_.is_damped(); }
    // These add Kelvin-Voigt and mass-proportional damping.
    void add_damping_force(const Motions<Nodes>& motions,
                           Histories histories,
                           NodalVector<Nodes>& force) const;
    void add_damping_tangent(const Motions<Nodes>& motions,
                             Histories histories,
                             const Linearizations<Nodes>& linearizations,
                             NodalMatrix<Nodes>& tangent) const;
    double damping_action(const Motions<Nodes>& previous,
                          const Motions<Nodes>& trial,
                          Histories histories) const;
    // These add Kelvin-Voigt damping alone.
    void add_viscous_force(const Motions<Nodes>& motions,
                           Histories histories,
                           NodalVector<Nodes>& force) const;
    void add_viscous_tangent(const Motions<Nodes>& motions,
                             Histories histories,
                             const Linearizations<Nodes>& linearizations,
                             NodalMatrix<Nodes>& tangent) const;

    // Sets the histories for a rod in its reference shape.
    void start(std::span<SectionHistory> histories) const;
    // Takes the trial motion as the last accepted step.
    void commit(const Motions<Nodes>& motions, Histories histories, WritableHistories after) const;
    // The number of values that the laws of its sections remember.
    int memory_count() const { return rod_.memory_count(); }
    bool has_law() const { return rod_.has_law(); }
    // Whether the Kelvin-Voigt damping of its components differs.
    bool is_damped_unevenly() const { return rod_.section(0).damping_roots.has_value(); }
    // Returns the largest rotation between nodes that the interpolation takes the short way round, at most π.
    double largest_relative_rotation(const Motions<Nodes>& motions) const;

    double strain_energy(const Motions<Nodes>& motions, Histories histories) const;
    // Computes the dissipation of its sections' laws since the last accepted step.
    double dissipated_energy(const Motions<Nodes>& motions, Histories histories) const;
    void add_driven_points(const Motions<Nodes>& motions,
                           Histories histories,
                           std::vector<DrivenPoint>& points) const;
    double kinetic_energy(const Motions<Nodes>& motions) const;
    double gravity_potential(const Motions<Nodes>& motions, const Vec3& gravity) const;
    Momentum momentum(const Motions<Nodes>& motions) const;

    // Computes strains and resultants in the middle.
    SectionValues section_values(const Motions<Nodes>& motions, Histories histories) const;
    // Computes the values at ξ, −1 to 1, except `start`, which needs positions at t = 0. `force` is the force
    // of the element and the loads along it on its nodes: in equilibrium, at the end nodes the resultants
    // there.
    PointValues point_values(const Motions<Nodes>& motions,
                             Histories histories,
                             const NodalVector<Nodes>& force,
                             double xi) const;

  private:
    using Rod = InterpolatedRod<Nodes>;
    using PointHistories = typename Rod::PointHistories;

    // Returns the attitudes from which each force point's rotation is measured: those in State, or the map's
    // own.
    static Histories histories_of_points(Histories histories);
    static Motions<Nodes> point_at(const std::array<NodeMotion, Nodes>& nodal);
    static std::array<NodeMotion, Nodes> make_reference(const RodElementGeometry<Nodes>& geometry);
    static PointHistories compute_start(const RodElementGeometry<Nodes>& geometry);
    static Rod make_rod(const RodElementGeometry<Nodes>& geometry, const ElementSections<Nodes>& sections);

    // The objective element with two nodes has closed forms, for linear sections.
    static constexpr bool is_two_node_objective = Nodes == 2 && std::is_same_v<Map, ObjectiveMap<2>>;
    template <class Visitor>
    void visit_state(const Motions<Nodes>& motions, Visitor&& visit) const;
    bool has_closed_form(Histories histories) const {
        return is_two_node_objective && rod_.is_linear(histories);
    }
    // Calls visit(rod, rotation, axes of a, r_b − r_a), the arguments of a TwoNodeRod<double>::State.
    template <class Visitor>
    void visit_two_nodes(const Motions<Nodes>& motions, Visitor&& visit) const;

    Rod rod_;
    RodInertia<Nodes> inertia_;
    struct Nothing {};
    [[no_unique_address]] std::conditional_t<(history_count > 0), PointHistories, Nothing> start_;
};

template <int Nodes>
using SimoElement = RodElement<Nodes, SimoMap<Nodes>>;
template <int Nodes>
using ObjectiveElement = RodElement<Nodes, ObjectiveMap<Nodes>>;

static_assert(Element<SimoElement<2>>);
static_assert(Element<ObjectiveElement<2>>);
extern template class RodElement<2, SimoMap<2>>;
extern template class RodElement<3, SimoMap<3>>;
extern template class RodElement<4, SimoMap<4>>;
extern template class RodElement<5, SimoMap<5>>;
extern template class RodElement<2, ObjectiveMap<2>>;
extern template class RodElement<3, ObjectiveMap<3>>;
extern template class RodElement<4, ObjectiveMap<4>>;
extern template class RodElement<5, ObjectiveMap<5>>;

}  // namespace gxrod
