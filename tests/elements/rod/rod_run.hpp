#pragma once

#include <string>
#include <type_traits>
#include <vector>

#include "elements/rod/rod_element.hpp"
#include "rotation/rotation_map.hpp"
#include "state/increment.hpp"
#include "tools/dense_algebra.hpp"
#include "tools/rod_models.hpp"

// Rods without a model: elements of one kind along a line.
namespace gxrod::tools {

template <class E>
struct RodRun {
    static constexpr int node_count = E::node_count;
    static constexpr int order = node_count - 1;

    double piece_length;
    std::vector<RodElementGeometry<node_count>> geometries;
    std::vector<E> elements;
    std::vector<double> arc_length;    // per node
    std::vector<NodeMotion> previous;  // at the last commit
    std::vector<NodeMotion> motions;
    std::vector<SectionHistory> histories;

    RodRun(const Line& line, double length, int pieces, const Section& section)
        : piece_length(length / pieces), histories(static_cast<std::size_t>(pieces * E::history_count)) {
        const NodeValues<node_count> at = compute_node_positions<node_count>();
        for (int e = 0; e < pieces; ++e) {
            RodElementGeometry<node_count> geometry;
            for (int i = 0; i < node_count; ++i) {
                const double s = (e + 0.5 * (1.0 + at[i])) * piece_length;
                geometry.nodes[i] = e * order + i;
                geometry.positions[i] = line(s).r;
                geometry.triads[i] = line(s).axes;
                if (i == 0 && e > 0) continue;
                arc_length.push_back(s);
                motions.push_back({});
                motions.back().r = geometry.positions[i];
            }
            geometries.push_back(geometry);
            elements.emplace_back(geometry, section);
            elements.back().start(writable_axes_of(e));
        }
        previous = motions;
    }

    int piece_count() const { return static_cast<int>(elements.size()); }
    Motions<node_count> motions_of(int e) const {
        Motions<node_count> pointers;
        for (int i = 0; i < node_count; ++i) pointers[i] = &motions[e * order + i];
        return pointers;
    }
    Histories histories_of(int e) const {
        return {.axes = {histories.data() + e * E::history_count, E::history_count}};
    }
    std::span<SectionHistory> writable_axes_of(int e) {
        return {histories.data() + e * E::history_count, static_cast<std::size_t>(E::history_count)};
    }
    SectionValues values(int e) const { return elements[e].section_values(motions_of(e), histories_of(e)); }

    // In one step from the last commit; Λ since the reference shape.
    void place_node(int node, const Vec3& r, const Quat& Lambda) {
        place(previous[node], r, log(Lambda * previous[node].Lambda.conjugate()), motions[node]);
    }
    void commit() {
        for (int e = 0; e < piece_count(); ++e)
            elements[e].commit(motions_of(e), histories_of(e), {.axes = writable_axes_of(e)});
        for (NodeMotion& motion : motions) motion.theta.setZero();
        previous = motions;
    }

    // The nodal motion of constant strains, exact: the section turns by K along the run, which must be
    // straight, and at every force point the centreline has the slope Λ (e₁ + Γ). The start node turns by
    // `turn`.
    void strain(const Vec3& Gamma, const Vec3& K, const Quat& turn) {
        const Quat axes = geometries[0].triads[0];
        const auto section_axes = [&](double s) { return turn * axes * exp_quaternion(s * K); };
        const auto rule = compute_gauss_rule<order>();
        Vec3 start = previous[0].r;
        for (int e = 0; e < piece_count(); ++e) {
            Eigen::Matrix<double, order, order> slopes;  // of N_1 …, those of N_0 being what is missing to 0
            Eigen::Matrix<double, order, 3> wanted;
            for (int p = 0; p < order; ++p) {
                slopes.row(p) = compute_shape_slopes<node_count>(rule[p].xi).template tail<order>();
                const double s = (e + 0.5 * (1.0 + rule[p].xi)) * piece_length;
                wanted.row(p) = 0.5 * piece_length * (section_axes(s) * (Vec3::UnitX() + Gamma));
            }
            const Eigen::Matrix<double, order, 3> from_start = solve_dense(slopes, wanted);
            for (int i = 0; i < node_count; ++i) {
                const int node = e * order + i;
                const Vec3 r = i == 0 ? start : Vec3(start + from_start.row(i - 1).transpose());
                place_node(node, r, section_axes(arc_length[node]) * axes.conjugate());
            }
            start += from_start.row(order - 1).transpose();
        }
    }

    // Internal force at every node.
    std::vector<Vec6> compute_forces() const {
        std::vector<Vec6> forces(motions.size(), Vec6::Zero());
        for (int e = 0; e < piece_count(); ++e) {
            NodalVector<node_count> force = NodalVector<node_count>::Zero();
            elements[e].add_internal_force(motions_of(e), histories_of(e), force);
            for (int i = 0; i < node_count; ++i) {
                forces[e * order + i] += force.template segment<6>(6 * i);
            }
        }
        return forces;
    }
};

template <class E>
std::string name_of_rod() {
    return (E::history_count > 0 ? "simo, order " : "objective, order ") + std::to_string(E::node_count - 1);
}

// Calls visit(std::type_identity<E>()) for every order of one kind.
template <template <int> class Kind, class Visit>
void for_each_order(Visit&& visit) {
    visit(std::type_identity<Kind<2>>());
    visit(std::type_identity<Kind<3>>());
    visit(std::type_identity<Kind<4>>());
    visit(std::type_identity<Kind<5>>());
}

template <class Visit>
void for_each_rod(Visit&& visit) {
    for_each_order<ObjectiveElement>(visit);
    for_each_order<SimoElement>(visit);
}

}  // namespace gxrod::tools
