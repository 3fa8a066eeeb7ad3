#include "elements/rod/tendon_slopes.hpp"

#include "rotation/rotation_map.hpp"
#include "rotation/tangent_map.hpp"

namespace gxrod {
namespace {

// q of a force point and Λ there, with their derivatives: those of spins are spatial.
template <int Nodes>
struct PointSlope {
    using Rows = Eigen::Matrix<double, 3, 6 * Nodes>;

    double weight;
    Vec3 q;
    Quat axes;
    Rows by_nodes = Rows::Zero();  // ∂q
    Rows spin = Rows::Zero();
};

// The derivative by (δr, δφ) of three functions of the local motion, which have this one by (r′, θ, θ′) at a
// point.
template <int Nodes, class Map>
typename PointSlope<Nodes>::Rows pull_back(const Map& map,
                                           const Eigen::Matrix<double, 3, 9>& by_fields,
                                           const NodeValues<Nodes>& shape,
                                           const NodeValues<Nodes>& slope) {
    typename PointSlope<Nodes>::Rows rows;
    for (int k = 0; k < 3; ++k) {
        NodalVector<Nodes> local, pulled = NodalVector<Nodes>::Zero();
        for (int i = 0; i < Nodes; ++i) {
            local.template segment<3>(6 * i) = slope[i] * by_fields.row(k).head<3>();
            local.template segment<3>(6 * i + 3) =
                shape[i] * by_fields.row(k).segment<3>(3) + slope[i] * by_fields.row(k).tail<3>();
        }
        map.add_force(local, pulled);
        rows.row(k) = pulled.transpose();
    }
    return rows;
}

template <int Nodes, class Map>
PointSlope<Nodes> compute_point_slope(const Map& map,
                                      const typename InterpolatedRod<Nodes>::ReferencePoint& reference,
                                      const QuadraturePoint& point,
                                      const SectionHistory& history,
                                      const TendonPull& pull,
                                      bool with_gradients) {
    const NodeValues<Nodes> shape = compute_shape_functions<Nodes>(point.xi);
    const NodeValues<Nodes> slope = compute_shape_slopes<Nodes>(point.xi) / reference.jacobian;
    const LocalMotion<Nodes>& local = map.local();
    const SectionFields fields{local.r * slope, local.theta * shape, local.theta * slope};
    const Quat axes = compute_section_axes(fields.theta, history);
    PointSlope<Nodes> result{.weight = point.weight * reference.jacobian,
                             .q = axes.conjugate() * fields.r_prime +
                                  compute_total_curvature(fields, history).cross(pull.at) + pull.slope,
                             .axes = map.turn_out(axes)};
    if (!with_gradients) return result;
    const StrainGradient by_strain = compute_strain_gradient(fields, history);
    result.by_nodes = pull_back<Nodes>(
        map, by_strain.topRows<3>() - spin(pull.at) * by_strain.bottomRows<3>(), shape, slope);
    Eigen::Matrix<double, 3, 9> of_spin = Eigen::Matrix<double, 3, 9>::Zero();
    of_spin.middleCols<3>(3) = tangent_map(fields.theta);
    result.spin =
        map.turn_out(Quat::Identity()).toRotationMatrix() * pull_back<Nodes>(map, of_spin, shape, slope) +
        map.compute_frame_spin();
    return result;
}

template <int Nodes>
TendonSlope<Nodes> turn_out(const PointSlope<Nodes>& point) {
    const Vec3 slope = point.axes * point.q;
    return {point.weight, slope, point.axes.toRotationMatrix() * point.by_nodes - spin(slope) * point.spin};
}

// At an end of the element, −1 or 1.
template <int Nodes>
TendonSlope<Nodes> compute_end_slope(const std::array<PointSlope<Nodes>, Nodes - 1>& points,
                                     const Quat& axes,
                                     double end) {
    NodeValues<Nodes - 1> at;
    const auto rule = compute_gauss_rule<Nodes - 1>();
    for (int p = 0; p < Nodes - 1; ++p) at[p] = rule[p].xi;
    const NodeValues<Nodes - 1> shares = compute_lagrange<Nodes - 1>(at, end);
    PointSlope<Nodes> there{.weight = 0.0, .q = Vec3::Zero(), .axes = axes};
    for (int p = 0; p < Nodes - 1; ++p) {
        there.q += shares[p] * points[p].q;
        there.by_nodes += shares[p] * points[p].by_nodes;
    }
    there.spin.template middleCols<3>(end < 0.0 ? 3 : 6 * Nodes - 3).setIdentity();
    return turn_out(there);
}

template <class E>
struct MapOf;
template <int Nodes, class Of>
struct MapOf<RodElement<Nodes, Of>> {
    using Map = Of;
};

}  // namespace

template <class E>
TendonSlopes<E::node_count> compute_tendon_slopes(const E& element,
                                                  const Motions<E::node_count>& motions,
                                                  Histories histories,
                                                  bool with_gradients) {
    using Map = typename MapOf<E>::Map;
    constexpr int Nodes = E::node_count;
    static const SectionHistory own{Quat::Identity(), Vec3::Zero()};
    const Map map(motions, element.triads());
    const auto rule = compute_gauss_rule<Nodes - 1>();
    std::array<PointSlope<Nodes>, Nodes - 1> points;
    TendonSlopes<Nodes> slopes;
    for (int p = 0; p < Nodes - 1; ++p) {
        points[p] = compute_point_slope<Nodes>(map,
                                               element.interpolated_rod().reference(p),
                                               rule[p],
                                               Map::history_count > 0 ? histories.axes[p] : own,
                                               histories.drives[p].pulls.front(),
                                               with_gradients);
        slopes[p + 1] = turn_out(points[p]);
    }
    slopes.front() = compute_end_slope<Nodes>(points, motions[0]->Lambda * element.triads()[0], -1.0);
    slopes.back() =
        compute_end_slope<Nodes>(points, motions[Nodes - 1]->Lambda * element.triads()[Nodes - 1], 1.0);
    return slopes;
}

template TendonSlopes<2> compute_tendon_slopes<SimoElement<2>>(const SimoElement<2>&,
                                                               const Motions<2>&,
                                                               Histories,
                                                               bool);
template TendonSlopes<3> compute_tendon_slopes<SimoElement<3>>(const SimoElement<3>&,
                                                               const Motions<3>&,
                                                               Histories,
                                                               bool);
template TendonSlopes<4> compute_tendon_slopes<SimoElement<4>>(const SimoElement<4>&,
                                                               const Motions<4>&,
                                                               Histories,
                                                               bool);
template TendonSlopes<5> compute_tendon_slopes<SimoElement<5>>(const SimoElement<5>&,
                                                               const Motions<5>&,
                                                               Histories,
                                                               bool);
template TendonSlopes<2> compute_tendon_slopes<ObjectiveElement<2>>(const ObjectiveElement<2>&,
                                                                    const Motions<2>&,
                                                                    Histories,
                                                                    bool);
template TendonSlopes<3> compute_tendon_slopes<ObjectiveElement<3>>(const ObjectiveElement<3>&,
                                                                    const Motions<3>&,
                                                                    Histories,
                                                                    bool);
template TendonSlopes<4> compute_tendon_slopes<ObjectiveElement<4>>(const ObjectiveElement<4>&,
                                                                    const Motions<4>&,
                                                                    Histories,
                                                                    bool);
template TendonSlopes<5> compute_tendon_slopes<ObjectiveElement<5>>(const ObjectiveElement<5>&,
                                                                    const Motions<5>&,
                                                                    Histories,
                                                                    bool);

}  // namespace gxrod
