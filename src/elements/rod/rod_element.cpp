#include "elements/rod/rod_element.hpp"

#include "elements/rod/two_node_rod.hpp"
#include "rotation/rotation_map.hpp"

namespace gxrod {

namespace {

void add_tangents(const TwoNodeRod<double>::Tangents& t,
                  const Linearizations<2>& linearizations,
                  NodalMatrix<2>& tangent) {
    const double at_a = linearizations[0]->placement;
    const double at_b = linearizations[1]->placement;
    const auto add = [&](int row, const Mat3& by_u, const Mat3& by_a, const Mat3& by_b) {
        tangent.block<3, 3>(row, 0) -= at_a * by_u;
        tangent.block<3, 3>(row, 3) += at_a * by_a;
        tangent.block<3, 3>(row, 6) += at_b * by_u;
        tangent.block<3, 3>(row, 9) += at_b * by_b;
    };
    add(0, -t.n_u, -t.n_a, -t.n_b);
    add(3, t.a_u, t.a_a, t.a_b);
    add(6, t.n_u, t.n_a, t.n_b);
    add(9, t.b_u, t.b_a, t.b_b);
}

// The rates of the map follow nodal rates as its motion follows increments.
template <int Nodes>
std::array<NodeMotion, Nodes> with_rates(const Motions<Nodes>& motions, const NodalVector<Nodes>& rates) {
    std::array<NodeMotion, Nodes> moving;
    for (int i = 0; i < Nodes; ++i) {
        moving[i] = *motions[i];
        moving[i].v = rates.template segment<3>(6 * i);
        moving[i].omega = rates.template segment<3>(6 * i + 3);
    }
    return moving;
}

}  // namespace

template <int Nodes, class Map>
RodElement<Nodes, Map>::RodElement(const RodElementGeometry<Nodes>& geometry,
                                   const ElementSections<Nodes>& sections)
    : nodes(geometry.nodes), rod_(make_rod(geometry, sections)), inertia_(geometry, sections) {
    if constexpr (history_count > 0) start_ = compute_start(geometry);
}

template <int Nodes, class Map>
template <class Visitor>
void RodElement<Nodes, Map>::visit_two_nodes(const Motions<Nodes>& motions, Visitor&& visit) const {
    static_assert(is_two_node_objective);
    const auto& [jacobian, strain] = rod_.reference(0);
    const Mat6& C = rod_.section(0).stiffness;
    const TwoNodeRod<double> rod{2.0 * jacobian,
                                 strain.Gamma,
                                 strain.Kappa,
                                 C.topLeftCorner<3, 3>(),
                                 C.topRightCorner<3, 3>(),
                                 C.bottomRightCorner<3, 3>()};
    const Quat a = motions[0]->Lambda * triads()[0];
    const Quat b = motions[1]->Lambda * triads()[1];
    const HalfRotation<double> rotation = split_rotation(a.conjugate() * b);
    const Vec3 l = motions[1]->r - motions[0]->r;
    visit(rod, rotation, a, l);
}

// Calls visit with the two-node rod in the state of these motions.
template <int Nodes, class Map>
template <class Visitor>
void RodElement<Nodes, Map>::visit_state(const Motions<Nodes>& motions, Visitor&& visit) const {
    visit_two_nodes(motions, [&](const auto& rod, const auto& rotation, const Quat& axes_a, const Vec3& l) {
        visit(TwoNodeRod<double>::State(rod, rotation, axes_a, l));
    });
}

template <int Nodes, class Map>
Motions<Nodes> RodElement<Nodes, Map>::point_at(const std::array<NodeMotion, Nodes>& nodal) {
    Motions<Nodes> pointers;
    for (int i = 0; i < Nodes; ++i) pointers[i] = &nodal[i];
    return pointers;
}

template <int Nodes, class Map>
std::array<NodeMotion, Nodes> RodElement<Nodes, Map>::make_reference(
    const RodElementGeometry<Nodes>& geometry) {
    std::array<NodeMotion, Nodes> nodal;
    for (int i = 0; i < Nodes; ++i) nodal[i].r = geometry.positions[i];
    return nodal;
}

// Section axes and curvature of the force points of the shape at t = 0. Its triads are interpolated as the
// objective element does it, for both kinds.
template <int Nodes, class Map>
auto RodElement<Nodes, Map>::compute_start(const RodElementGeometry<Nodes>& geometry) -> PointHistories {
    PointHistories histories;
    histories.fill({Quat::Identity(), Vec3::Zero()});
    if constexpr (history_count > 0) {
        const std::array<NodeMotion, Nodes> nodal = make_reference(geometry);
        const ObjectiveMap<Nodes> map(point_at(nodal), geometry.triads);
        // Its own reference is of no matter for where its points are.
        const InterpolatedRod<Nodes> rod(map.local(), histories, {}, geometry.strains);
        rod.advance(map.local(), histories);
        for (SectionHistory& history : histories) history.Lambda = map.turn_out(history.Lambda);
    }
    return histories;
}

template <int Nodes, class Map>
auto RodElement<Nodes, Map>::make_rod(const RodElementGeometry<Nodes>& geometry,
                                      const ElementSections<Nodes>& sections) -> Rod {
    const RodElementGeometry<Nodes> reference = geometry.reference();
    const std::array<NodeMotion, Nodes> nodal = make_reference(reference);
    const Map map(point_at(nodal), reference.triads);
    return Rod(map.local(), compute_start(reference), sections.at_forces, geometry.strains);
}

template <int Nodes, class Map>
Histories RodElement<Nodes, Map>::histories_of_points(Histories histories) {
    if constexpr (history_count > 0) return histories;
    static const PointHistories own = [] {
        PointHistories same;
        same.fill({Quat::Identity(), Vec3::Zero()});
        return same;
    }();
    histories.axes = own;
    return histories;
}

template <int Nodes, class Map>
void RodElement<Nodes, Map>::add_internal_force(const Motions<Nodes>& motions,
                                                Histories histories,
                                                NodalVector<Nodes>& force) const {
    if constexpr (is_two_node_objective) {
        if (has_closed_form(histories)) {
            visit_state(motions, [&](const TwoNodeRod<double>::State& state) {
                const TwoNodeRod<double>::Forces forces = state.forces();
                force.template segment<3>(0) -= forces.n;
                force.template segment<3>(3) += forces.moment_a;
                force.template segment<3>(6) += forces.n;
                force.template segment<3>(9) += forces.moment_b;
            });
            return;
        }
    }
    const Map map(motions, triads());
    map.add_force(rod_.compute_gradient(map.local(), histories_of_points(histories)), force);
}

template <int Nodes, class Map>
void RodElement<Nodes, Map>::add_internal_tangent(const Motions<Nodes>& motions,
                                                  Histories histories,
                                                  const Linearizations<Nodes>& linearizations,
                                                  NodalMatrix<Nodes>& tangent) const {
    if constexpr (is_two_node_objective) {
        if (has_closed_form(histories)) {
            visit_state(motions, [&](const TwoNodeRod<double>::State& state) {
                add_tangents(state.compute_tangents(), linearizations, tangent);
            });
            return;
        }
    }
    const Map map(motions, triads());
    const Histories known = histories_of_points(histories);
    const auto derivatives = rod_.compute_derivatives(map.local(), known);
    map.add_tangent(derivatives.gradient, derivatives.hessian, linearizations, tangent);
}

template <int Nodes, class Map>
void RodElement<Nodes, Map>::add_mixed_tangent(const Motions<Nodes>& motions,
                                               Histories histories,
                                               Resultants resultants,
                                               const Linearizations<Nodes>& linearizations,
                                               NodalMatrix<Nodes>& tangent) const {
    if constexpr (is_two_node_objective) {
        if (has_closed_form(histories)) {
            visit_state(motions, [&](TwoNodeRod<double>::State state) {
                state.set_resultants({resultants[0].head<3>(), resultants[0].tail<3>()});
                add_tangents(state.compute_tangents(), linearizations, tangent);
            });
            return;
        }
    }
    const Map map(motions, triads());
    const Histories known = histories_of_points(histories);
    map.add_tangent(rod_.compute_force_of(map.local(), known, resultants),
                    rod_.compute_mixed_hessian(map.local(), known, resultants),
                    linearizations,
                    tangent);
}

template <int Nodes, class Map>
void RodElement<Nodes, Map>::advance_resultants(const Motions<Nodes>& motions,
                                                Histories histories,
                                                const NodalVector<Nodes>& increment,
                                                std::span<Vec6> resultants) const {
    if constexpr (is_two_node_objective) {
        if (has_closed_form(histories)) {
            visit_state(motions, [&](const TwoNodeRod<double>::State& state) {
                const auto [N, M] = state.advance_resultants(
                    increment.template segment<3>(6) - increment.template segment<3>(0),
                    increment.template segment<3>(3),
                    increment.template segment<3>(9));
                resultants[0] << N, M;
            });
            return;
        }
    }
    const Map map(motions, triads());
    const std::array<NodeMotion, Nodes> moving = with_rates<Nodes>(motions, increment);
    rod_.advance_resultants(
        map.local(), map.compute_rates(point_at(moving)), histories_of_points(histories), resultants);
}

template <int Nodes, class Map>
Vec6 RodElement<Nodes, Map>::compute_strain_work(const Motions<Nodes>& motions,
                                                 Histories histories,
                                                 const NodalVector<Nodes>& increment) const {
    if constexpr (is_two_node_objective) {
        if (has_closed_form(histories)) {
            Vec6 change;
            visit_state(motions, [&](const TwoNodeRod<double>::State& state) {
                const auto [Gamma, Kappa] = state.compute_strain_increments(
                    increment.template segment<3>(6) - increment.template segment<3>(0),
                    increment.template segment<3>(3),
                    increment.template segment<3>(9));
                change << Gamma, Kappa;
            });
            return rod_.compute_strain_work(change, rod_.section(0).stiffness);
        }
    }
    const Map map(motions, triads());
    const std::array<NodeMotion, Nodes> moving = with_rates<Nodes>(motions, increment);
    return rod_.compute_strain_work(
        map.local(), map.compute_rates(point_at(moving)), histories_of_points(histories));
}

template <int Nodes, class Map>
void RodElement<Nodes, Map>::add_inertial_force(const Motions<Nodes>& motions,
                                                const Vec3& gravity,
                                                NodalVector<Nodes>& force) const {
    inertia_.add_force(motions, gravity, force);
}

template <int Nodes, class Map>
void RodElement<Nodes, Map>::add_inertial_tangent(const Motions<Nodes>& motions,
                                                  const Vec3& gravity,
                                                  const Linearizations<Nodes>& linearizations,
                                                  NodalMatrix<Nodes>& tangent) const {
    inertia_.add_tangent(motions, gravity, linearizations, tangent);
}

template <int Nodes, class Map>
void RodElement<Nodes, Map>::add_viscous_force(const Motions<Nodes>& motions,
                                               Histories histories,
                                               NodalVector<Nodes>& force) const {
    if (!rod_.is_damped()) return;
    const Map map(motions, triads());
    map.add_force(
        rod_.compute_damping_force(map.local(), map.compute_rates(motions), histories_of_points(histories)),
        force);
}

template <int Nodes, class Map>
void RodElement<Nodes, Map>::add_viscous_tangent(const Motions<Nodes>& motions,
                                                 Histories histories,
                                                 const Linearizations<Nodes>& linearizations,
                                                 NodalMatrix<Nodes>& tangent) const {
    if (!rod_.is_damped()) return;
    const Map map(motions, triads());
    const Histories known = histories_of_points(histories);
    const LocalMotion<Nodes> rates = map.compute_rates(motions);
    const auto tangents = rod_.compute_damping_tangents(map.local(), rates, known);
    map.add_tangent(
        rod_.compute_damping_force(map.local(), rates, known), tangents.by_motion, linearizations, tangent);
    map.add_rate_tangent(motions, tangents.by_rates, linearizations, tangent);
}

template <int Nodes, class Map>
void RodElement<Nodes, Map>::add_damping_force(const Motions<Nodes>& motions,
                                               Histories histories,
                                               NodalVector<Nodes>& force) const {
    add_viscous_force(motions, histories, force);
    if (inertia_.is_damped()) inertia_.add_damping_force(motions, force);
}

template <int Nodes, class Map>
void RodElement<Nodes, Map>::add_damping_tangent(const Motions<Nodes>& motions,
                                                 Histories histories,
                                                 const Linearizations<Nodes>& linearizations,
                                                 NodalMatrix<Nodes>& tangent) const {
    add_viscous_tangent(motions, histories, linearizations, tangent);
    if (inertia_.is_damped()) inertia_.add_damping_tangent(motions, linearizations, tangent);
}

template <int Nodes, class Map>
double RodElement<Nodes, Map>::damping_action(const Motions<Nodes>& previous,
                                              const Motions<Nodes>& trial,
                                              Histories histories) const {
    double action = 0.0;
    if constexpr (is_two_node_objective) {
        if (rod_.is_damped()) {
            const auto strain_of = [&](const Motions<Nodes>& motions) {
                Vec6 strain;
                visit_two_nodes(
                    motions, [&](const auto& rod, const auto& rotation, const Quat& axes_a, const Vec3& l) {
                        const Mat3 frame = (axes_a * rotation.half).toRotationMatrix();
                        strain << rod.compute_force_strain(frame, l), rod.compute_moment_strain(rotation);
                    });
                return strain;
            };
            action += rod_.damping_action(strain_of(trial) - strain_of(previous));
        }
    } else if (rod_.is_damped()) {
        action += rod_.damping_action(
            Map(previous, triads()).local(), Map(trial, triads()).local(), histories_of_points(histories));
    }
    if (inertia_.is_damped()) action += inertia_.damping_action(previous, trial);
    return action;
}

template <int Nodes, class Map>
void RodElement<Nodes, Map>::start(std::span<SectionHistory> histories) const {
    if constexpr (history_count > 0) std::copy(start_.begin(), start_.end(), histories.begin());
}

// What the law remembers follows from strains, which are seen from the axes of the step before.
template <int Nodes, class Map>
void RodElement<Nodes, Map>::commit(const Motions<Nodes>& motions,
                                    Histories histories,
                                    WritableHistories after) const {
    const bool remembers = !after.memory.empty();
    if (history_count == 0 && !remembers) return;
    const Map map(motions, triads());
    if (remembers) rod_.advance_memory(map.local(), histories_of_points(histories), after.memory);
    if constexpr (history_count > 0) rod_.advance(map.local(), after.axes);
}

template <int Nodes, class Map>
double RodElement<Nodes, Map>::largest_relative_rotation(const Motions<Nodes>& motions) const {
    if constexpr (is_two_node_objective) {
        const Quat a = motions[0]->Lambda * triads()[0];
        return log(a.conjugate() * (motions[1]->Lambda * triads()[1])).norm();
    } else {
        return Map(motions, triads()).largest_relative_rotation();
    }
}

template <int Nodes, class Map>
double RodElement<Nodes, Map>::strain_energy(const Motions<Nodes>& motions, Histories histories) const {
    if constexpr (is_two_node_objective) {
        if (has_closed_form(histories)) {
            double energy = 0.0;
            visit_state(motions, [&](const TwoNodeRod<double>::State& state) { energy = state.energy(); });
            return energy;
        }
    }
    return rod_.strain_energy(Map(motions, triads()).local(), histories_of_points(histories));
}

template <int Nodes, class Map>
double RodElement<Nodes, Map>::dissipated_energy(const Motions<Nodes>& motions, Histories histories) const {
    if (!has_law()) return 0.0;
    return rod_.dissipated_energy(Map(motions, triads()).local(), histories_of_points(histories));
}

template <int Nodes, class Map>
void RodElement<Nodes, Map>::add_driven_points(const Motions<Nodes>& motions,
                                               Histories histories,
                                               std::vector<DrivenPoint>& points) const {
    rod_.add_driven_points(Map(motions, triads()).local(), histories_of_points(histories), points);
}

template <int Nodes, class Map>
double RodElement<Nodes, Map>::kinetic_energy(const Motions<Nodes>& motions) const {
    return inertia_.kinetic_energy(motions);
}

template <int Nodes, class Map>
double RodElement<Nodes, Map>::gravity_potential(const Motions<Nodes>& motions, const Vec3& gravity) const {
    return inertia_.gravity_potential(motions, gravity);
}

template <int Nodes, class Map>
Momentum RodElement<Nodes, Map>::momentum(const Motions<Nodes>& motions) const {
    return inertia_.momentum(motions);
}

template <int Nodes, class Map>
SectionValues RodElement<Nodes, Map>::section_values(const Motions<Nodes>& motions,
                                                     Histories histories) const {
    const Map map(motions, triads());
    const Histories known = histories_of_points(histories);
    const typename Rod::SectionState middle =
        rod_.compute_middle_state(map.local(), map.compute_rates(motions), known);
    const Vec6& strain = middle.strain;
    const Vec6& resultants = middle.resultants;
    Quat axes;
    if constexpr (Nodes % 2 == 0) {
        // A force point lies in the middle.
        const Vec3 theta = map.local().theta * compute_shape_functions<Nodes>(0.0);
        axes = map.turn_out(compute_section_axes(theta, known.axes[Nodes / 2 - 1]));
    } else {
        axes = motions[Nodes / 2]->Lambda * triads()[Nodes / 2];
    }
    return {resultants.head<3>(), resultants.tail<3>(), strain.head<3>(), strain.tail<3>(), axes};
}

template <int Nodes, class Map>
PointValues RodElement<Nodes, Map>::point_values(const Motions<Nodes>& motions,
                                                 Histories histories,
                                                 const NodalVector<Nodes>& force,
                                                 double xi) const {
    const NodeValues<Nodes> shape = compute_shape_functions<Nodes>(xi);
    PointValues values;
    NodeMotion& motion = values.motion;
    std::array<NodeMotion, Nodes> unturned;
    for (int i = 0; i < Nodes; ++i) {
        motion.r += shape[i] * motions[i]->r;
        motion.v += shape[i] * motions[i]->v;
        motion.a += shape[i] * motions[i]->a;
    }
    const ObjectiveMap<Nodes> objective(motions, triads());
    values.triad = ObjectiveMap<Nodes>(point_at(unturned), triads()).interpolate_axes(shape);
    motion.Lambda = objective.interpolate_axes(shape) * values.triad.conjugate();
    motion.omega = objective.interpolate_spin(motions, shape);

    const auto in_axes = [](const Quat& axes, const Vec6& spatial) {
        Vec6 material;
        material << axes.conjugate() * spatial.head<3>(), axes.conjugate() * spatial.tail<3>();
        return material;
    };
    const std::array<Vec6, 2> end_resultants{
        in_axes(motions.front()->Lambda * triads().front(), -force.template head<6>()),
        in_axes(motions.back()->Lambda * triads().back(), force.template tail<6>())};
    const Map map(motions, triads());
    // Between stations a stiffness is linear in s.
    Mat6 stiffness = Mat6::Zero();
    for (int i = 0; i < Nodes; ++i) stiffness += shape[i] * inertia_.section(i).stiffness;
    const typename Rod::SectionState state = rod_.interpolate_state(map.local(),
                                                                    map.compute_rates(motions),
                                                                    histories_of_points(histories),
                                                                    end_resultants,
                                                                    stiffness,
                                                                    xi);
    values.force = state.resultants.template head<3>();
    values.moment = state.resultants.template tail<3>();
    values.strain = state.strain.template head<3>();
    values.curvature = state.strain.template tail<3>();
    return values;
}

template class RodElement<2, SimoMap<2>>;
template class RodElement<3, SimoMap<3>>;
template class RodElement<4, SimoMap<4>>;
template class RodElement<5, SimoMap<5>>;
template class RodElement<2, ObjectiveMap<2>>;
template class RodElement<3, ObjectiveMap<3>>;
template class RodElement<4, ObjectiveMap<4>>;
template class RodElement<5, ObjectiveMap<5>>;

}  // namespace gxrod
