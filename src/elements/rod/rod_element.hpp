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

// A geometrically exact rod element: positions and rotation vectors interpolated, rotation vectors measured
// from where `Map` says.
template <int Nodes, class Map>
class RodElement {
  public:
    static constexpr int node_count = Nodes;
    static constexpr int history_count = Map::history_count;
    static constexpr int point_count = InterpolatedRod<Nodes>::point_count;
    static constexpr bool has_section = true;
    std::array<int, Nodes> nodes;

    RodElement(const RodElementGeometry<Nodes>& geometry, const ElementSections<Nodes>& sections);
    // One that shares its section with no other.
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
    // The same with `resultants` of its own in place of C E where these turn with the motion.
    void add_mixed_tangent(const Motions<Nodes>& motions,
                           Histories histories,
                           Resultants resultants,
                           const Linearizations<Nodes>& linearizations,
                           NodalMatrix<Nodes>& tangent) const;
    // Sets them to what they are after the increment (δr, δφ) to first order: S + D δE.
    void advance_resultants(const Motions<Nodes>& motions,
                            Histories histories,
                            const NodalVector<Nodes>& increment,
                            std::span<Vec6> resultants) const;
    // ∫ δE (D δE) ds, component by component, of the strains δE that the increment (δr, δφ) adds to first
    // order.
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
    // Kelvin-Voigt and mass-proportional.
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
    // Kelvin-Voigt alone.
    void add_viscous_force(const Motions<Nodes>& motions,
                           Histories histories,
                           NodalVector<Nodes>& force) const;
    void add_viscous_tangent(const Motions<Nodes>& motions,
                             Histories histories,
                             const Linearizations<Nodes>& linearizations,
                             NodalMatrix<Nodes>& tangent) const;

    // The histories of a rod in its reference shape.
    void start(std::span<SectionHistory> histories) const;
    // Takes the trial motion as the last accepted step.
    void commit(const Motions<Nodes>& motions, Histories histories, WritableHistories after) const;
    // Numbers that the laws of its sections remember.
    int memory_count() const { return rod_.memory_count(); }
    bool has_law() const { return rod_.has_law(); }
    // Whether the Kelvin-Voigt damping of its components differs.
    bool is_damped_unevenly() const { return rod_.section(0).damping_roots.has_value(); }
    // The largest rotation between nodes that the interpolation takes for the short way round, at most π.
    double largest_relative_rotation(const Motions<Nodes>& motions) const;

    double strain_energy(const Motions<Nodes>& motions, Histories histories) const;
    // What the laws of its sections have dissipated since the last accepted step.
    double dissipated_energy(const Motions<Nodes>& motions, Histories histories) const;
    void add_driven_points(const Motions<Nodes>& motions,
                           Histories histories,
                           std::vector<DrivenPoint>& points) const;
    double kinetic_energy(const Motions<Nodes>& motions) const;
    double gravity_potential(const Motions<Nodes>& motions, const Vec3& gravity) const;
    Momentum momentum(const Motions<Nodes>& motions) const;

    // Strains and resultants in the middle.
    SectionValues section_values(const Motions<Nodes>& motions, Histories histories) const;
    // At ξ, −1 to 1; but for `start`, which needs positions at t = 0. `force` is what the element and the
    // loads along it ask of its nodes: of an equilibrium, the end nodes' are the resultants there.
    PointValues point_values(const Motions<Nodes>& motions,
                             Histories histories,
                             const NodalVector<Nodes>& force,
                             double xi) const;

  private:
    using Rod = InterpolatedRod<Nodes>;
    using PointHistories = typename Rod::PointHistories;

    // Where each force point's rotation is measured from: what State remembers, or the map's own axes.
    static Histories histories_of_points(Histories histories);
    static Motions<Nodes> point_at(const std::array<NodeMotion, Nodes>& nodal);
    static std::array<NodeMotion, Nodes> make_reference(const RodElementGeometry<Nodes>& geometry);
    static PointHistories compute_start(const RodElementGeometry<Nodes>& geometry);
    static Rod make_rod(const RodElementGeometry<Nodes>& geometry, const ElementSections<Nodes>& sections);

    // The one with two nodes that is objective has closed forms, for linear sections.
    static constexpr bool is_two_node_objective = Nodes == 2 && std::is_same_v<Map, ObjectiveMap<2>>;
    template <class Visitor>
    void visit_state(const Motions<Nodes>& motions, Visitor&& visit) const;
    bool has_closed_form(Histories histories) const {
        return is_two_node_objective && rod_.is_linear(histories);
    }
    // Calls visit(rod, rotation, axes of a, r_b − r_a), which a TwoNodeRod<double>::State is made of.
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
