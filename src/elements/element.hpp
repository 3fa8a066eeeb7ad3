#pragma once

#include <array>
#include <concepts>
#include <span>

#include "elements/rigid_inertia.hpp"
#include "state/point_drive.hpp"
#include "state/state.hpp"

// The interface of all elements, by which assembly and the every_element tests treat all kinds alike.
//
// Node I of an element owns rows 6I … 6I+5 of its vectors and matrices: force (or δr), then moment about the
// node (or the spatial spin δφ). All are spatial. An element's force acts on the left of the equilibrium:
// internal + damping + inertial − external = 0.
namespace gxrod {

template <int Nodes>
using NodalVector = Eigen::Matrix<double, 6 * Nodes, 1>;
template <int Nodes>
using NodalMatrix = Eigen::Matrix<double, 6 * Nodes, 6 * Nodes>;

template <int Nodes>
using Motions = std::array<const NodeMotion*, Nodes>;
template <int Nodes>
using Linearizations = std::array<const NodeLinearization*, Nodes>;

// The history of an element's force points, one after the other, in addition to the motions of its nodes.
struct Histories {
    std::span<const SectionHistory> axes{};  // for elements that measure rotations from them
    std::span<const double> memory{};        // memory of its section's law, at the last accepted step
    double elapsed = 0.0;                    // time since that step; infinite if no time passes
    std::span<const PointDrive> drives{};    // actions within its sections; empty if there are none
};
// The same history for writing.
struct WritableHistories {
    std::span<SectionHistory> axes{};
    std::span<double> memory{};
};
// Resultants (N, M) at an element's force points, material, for the mixed tangent.
using Resultants = std::span<const Vec6>;

template <class E>
concept Element = requires(const E& element,
                           const Motions<E::node_count>& motions,
                           const Linearizations<E::node_count>& linearizations,
                           Histories histories,
                           std::span<SectionHistory> axes,
                           WritableHistories writable,
                           Resultants resultants,
                           std::span<Vec6> writable_resultants,
                           std::vector<DrivenPoint>& driven,
                           const Vec3& gravity,
                           NodalVector<E::node_count>& force,
                           NodalMatrix<E::node_count>& tangent) {
    { E::node_count } -> std::convertible_to<int>;
    { E::history_count } -> std::convertible_to<int>;
    { E::point_count } -> std::convertible_to<int>;
    { E::has_section } -> std::convertible_to<bool>;
    { element.nodes } -> std::convertible_to<std::array<int, E::node_count>>;
    element.add_internal_force(motions, histories, force);
    element.add_internal_tangent(motions, histories, linearizations, tangent);
    element.add_mixed_tangent(motions, histories, resultants, linearizations, tangent);
    element.advance_resultants(motions, histories, force, writable_resultants);
    element.add_inertial_force(motions, gravity, force);
    element.add_inertial_tangent(motions, gravity, linearizations, tangent);
    { element.is_damped() } -> std::same_as<bool>;
    element.add_damping_force(motions, histories, force);
    element.add_damping_tangent(motions, histories, linearizations, tangent);
    // The damping quadratic in the step from the first motions to the second, not negative: divided by the
    // duration of the step it is the dissipation.
    { element.damping_action(motions, motions, histories) } -> std::same_as<double>;
    element.start(axes);
    element.commit(motions, histories, writable);
    // The number of values that its sections remember, at all of its force points together.
    { element.memory_count() } -> std::same_as<int>;
    { element.has_law() } -> std::same_as<bool>;
    // The dissipation of its sections since the last accepted step.
    { element.dissipated_energy(motions, histories) } -> std::same_as<double>;
    // Adds the force points of an element with drives.
    element.add_driven_points(motions, histories, driven);
    { element.largest_relative_rotation(motions) } -> std::same_as<double>;
    { element.strain_energy(motions, histories) } -> std::same_as<double>;
    { element.kinetic_energy(motions) } -> std::same_as<double>;
    { element.gravity_potential(motions, gravity) } -> std::same_as<double>;
    { element.momentum(motions) } -> std::same_as<Momentum>;
};

}  // namespace gxrod
