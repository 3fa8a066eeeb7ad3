#include "elements/rod/interpolated_rod.hpp"

namespace gxrod {

namespace {

// Of a force point of any element: N_I, dN_I/dξ and the weight in ξ.
template <int Nodes>
struct PointShape {
    NodeValues<Nodes> shape, slope;
    double weight;
};

template <int Nodes>
std::array<PointShape<Nodes>, Nodes - 1> compute_point_shapes() {
    std::array<PointShape<Nodes>, Nodes - 1> points;
    const auto rule = compute_gauss_rule<Nodes - 1>();
    for (std::size_t p = 0; p < points.size(); ++p) {
        const auto [xi, weight] = rule[p];
        points[p] = {compute_shape_functions<Nodes>(xi), compute_shape_slopes<Nodes>(xi), weight};
    }
    return points;
}

template <int Nodes>
const PointShape<Nodes>& point_shape(int point) {
    static const auto shapes = compute_point_shapes<Nodes>();
    return shapes[point];
}

}  // namespace

template <int Nodes>
InterpolatedRod<Nodes>::InterpolatedRod(const LocalMotion<Nodes>& reference,
                                        const PointHistories& histories,
                                        const PointSections& sections)
    : sections_(sections) {
    for (int p = 0; p < point_count; ++p) {
        points_[p].jacobian = (reference.r * point_shape<Nodes>(p).slope).norm();
        // The strains of this very interpolation, so that the reference is free of strain to round-off.
        const ReferenceStrain none{Vec3::Zero(), Vec3::Zero()};
        const Vec6 strain = compute_strain(interpolate(force_point(p), reference), histories[p], none);
        points_[p].strain = {strain.head<3>(), strain.tail<3>()};
    }
}

template <int Nodes>
auto InterpolatedRod<Nodes>::force_point(int point) const -> ForcePoint {
    const auto& [shape, slope, weight] = point_shape<Nodes>(point);
    const auto& [jacobian, strain] = points_[point];
    return {shape, slope / jacobian, weight * jacobian, strain};
}

template <int Nodes>
SectionFields InterpolatedRod<Nodes>::interpolate(const ForcePoint& point, const LocalMotion<Nodes>& motion) {
    return {motion.r * point.slope, motion.theta * point.shape, motion.theta * point.slope};
}

template <int Nodes>
void InterpolatedRod<Nodes>::add_force(const ForcePoint& point,
                                       const Vec9& density,
                                       NodalVector<Nodes>& force) {
    for (int i = 0; i < Nodes; ++i) {
        const double shape = point.weight * point.shape[i];
        const double slope = point.weight * point.slope[i];
        force.template segment<3>(6 * i) += slope * density.head<3>();
        force.template segment<3>(6 * i + 3) += shape * density.segment<3>(3) + slope * density.tail<3>();
    }
}

template <int Nodes>
void InterpolatedRod<Nodes>::add_matrix(const ForcePoint& point,
                                        const Mat9& density,
                                        NodalMatrix<Nodes>& matrix) {
    for (int j = 0; j < Nodes; ++j) {
        const double shape = point.weight * point.shape[j];
        const double slope = point.weight * point.slope[j];
        Eigen::Matrix<double, 9, 6> columns;
        columns.leftCols<3>() = slope * density.leftCols<3>();
        columns.rightCols<3>() = shape * density.middleCols<3>(3) + slope * density.rightCols<3>();
        for (int i = 0; i < Nodes; ++i) {
            matrix.template block<3, 6>(6 * i, 6 * j) += point.slope[i] * columns.topRows<3>();
            matrix.template block<3, 6>(6 * i + 3, 6 * j) +=
                point.shape[i] * columns.middleRows<3>(3) + point.slope[i] * columns.bottomRows<3>();
        }
    }
}

template <int Nodes>
void InterpolatedRod<Nodes>::add_hessian(int p,
                                         const ForcePoint& point,
                                         const SectionFields& fields,
                                         const SectionHistory& history,
                                         const Vec6& resultants,
                                         NodalMatrix<Nodes>& hessian) const {
    const StrainGradient E_u = compute_strain_gradient(fields, history);
    const StrainGradient C_E_u = stiffness(p) * E_u;
    add_matrix(
        point, E_u.transpose() * C_E_u + compute_geometric_hessian(fields, history, resultants), hessian);
}

template <int Nodes>
double InterpolatedRod<Nodes>::strain_energy(const LocalMotion<Nodes>& motion, Histories histories) const {
    double energy = 0.0;
    for (int p = 0; p < point_count; ++p) {
        const ForcePoint point = force_point(p);
        const Vec6 strain = compute_strain(interpolate(point, motion), histories[p], point.reference);
        energy += 0.5 * point.weight * strain.dot(stiffness(p) * strain);
    }
    return energy;
}

template <int Nodes>
NodalVector<Nodes> InterpolatedRod<Nodes>::compute_gradient(const LocalMotion<Nodes>& motion,
                                                            Histories histories) const {
    NodalVector<Nodes> gradient = NodalVector<Nodes>::Zero();
    for (int p = 0; p < point_count; ++p) {
        const ForcePoint point = force_point(p);
        const SectionFields fields = interpolate(point, motion);
        const Vec6 resultants = stiffness(p) * compute_strain(fields, histories[p], point.reference);
        add_force(point, compute_strain_gradient(fields, histories[p]).transpose() * resultants, gradient);
    }
    return gradient;
}

template <int Nodes>
NodalMatrix<Nodes> InterpolatedRod<Nodes>::compute_hessian(const LocalMotion<Nodes>& motion,
                                                           Histories histories) const {
    NodalMatrix<Nodes> hessian = NodalMatrix<Nodes>::Zero();
    for (int p = 0; p < point_count; ++p) {
        const ForcePoint point = force_point(p);
        const SectionFields fields = interpolate(point, motion);
        const Vec6 resultants = stiffness(p) * compute_strain(fields, histories[p], point.reference);
        add_hessian(p, point, fields, histories[p], resultants, hessian);
    }
    return hessian;
}

template <int Nodes>
NodalVector<Nodes> InterpolatedRod<Nodes>::compute_force_of(const LocalMotion<Nodes>& motion,
                                                            Histories histories,
                                                            Resultants resultants) const {
    NodalVector<Nodes> force = NodalVector<Nodes>::Zero();
    for (int p = 0; p < point_count; ++p) {
        const ForcePoint point = force_point(p);
        const StrainGradient E_u = compute_strain_gradient(interpolate(point, motion), histories[p]);
        add_force(point, E_u.transpose() * resultants[p], force);
    }
    return force;
}

template <int Nodes>
NodalMatrix<Nodes> InterpolatedRod<Nodes>::compute_mixed_hessian(const LocalMotion<Nodes>& motion,
                                                                 Histories histories,
                                                                 Resultants resultants) const {
    NodalMatrix<Nodes> hessian = NodalMatrix<Nodes>::Zero();
    for (int p = 0; p < point_count; ++p) {
        const ForcePoint point = force_point(p);
        add_hessian(p, point, interpolate(point, motion), histories[p], resultants[p], hessian);
    }
    return hessian;
}

template <int Nodes>
void InterpolatedRod<Nodes>::advance_resultants(const LocalMotion<Nodes>& motion,
                                                const LocalMotion<Nodes>& increment,
                                                Histories histories,
                                                std::span<Vec6> resultants) const {
    for (int p = 0; p < point_count; ++p) {
        const ForcePoint point = force_point(p);
        const Vec6 strain = compute_strain(interpolate(point, motion), histories[p], point.reference);
        resultants[p] =
            stiffness(p) * (strain + compute_strain_rates(point, motion, increment, histories[p]));
    }
}

template <int Nodes>
Vec6 InterpolatedRod<Nodes>::compute_strain_rates(const ForcePoint& point,
                                                  const LocalMotion<Nodes>& motion,
                                                  const LocalMotion<Nodes>& rates,
                                                  const SectionHistory& history) const {
    const SectionFields u_dot = interpolate(point, rates);
    Vec9 stacked;
    stacked << u_dot.r_prime, u_dot.theta, u_dot.theta_prime;
    return compute_strain_gradient(interpolate(point, motion), history) * stacked;
}

template <int Nodes>
NodalVector<Nodes> InterpolatedRod<Nodes>::compute_damping_force(const LocalMotion<Nodes>& motion,
                                                                 const LocalMotion<Nodes>& rates,
                                                                 Histories histories) const {
    NodalVector<Nodes> force = NodalVector<Nodes>::Zero();
    for (int p = 0; p < point_count; ++p) {
        const ForcePoint point = force_point(p);
        const Vec6 resultants = section(p).kelvin_voigt *
                                (stiffness(p) * compute_strain_rates(point, motion, rates, histories[p]));
        const StrainGradient E_u = compute_strain_gradient(interpolate(point, motion), histories[p]);
        add_force(point, E_u.transpose() * resultants, force);
    }
    return force;
}

template <int Nodes>
double InterpolatedRod<Nodes>::damping_action(const Vec6& change) const {
    return force_point(0).weight * section(0).kelvin_voigt * change.dot(stiffness(0) * change);
}

template <int Nodes>
double InterpolatedRod<Nodes>::damping_action(const LocalMotion<Nodes>& previous,
                                              const LocalMotion<Nodes>& trial,
                                              Histories histories) const {
    double action = 0.0;
    for (int p = 0; p < point_count; ++p) {
        const ForcePoint point = force_point(p);
        const Vec6 change = compute_strain(interpolate(point, trial), histories[p], point.reference) -
                            compute_strain(interpolate(point, previous), histories[p], point.reference);
        action += point.weight * section(p).kelvin_voigt * change.dot(stiffness(p) * change);
    }
    return action;
}

template <int Nodes>
Vec6 InterpolatedRod<Nodes>::compute_strain_work(const Vec6& change) const {
    return force_point(0).weight * change.cwiseProduct(stiffness(0) * change);
}

template <int Nodes>
Vec6 InterpolatedRod<Nodes>::compute_strain_work(const LocalMotion<Nodes>& motion,
                                                 const LocalMotion<Nodes>& increment,
                                                 Histories histories) const {
    Vec6 work = Vec6::Zero();
    for (int p = 0; p < point_count; ++p) {
        const ForcePoint point = force_point(p);
        const Vec6 change = compute_strain_rates(point, motion, increment, histories[p]);
        work += point.weight * change.cwiseProduct(stiffness(p) * change);
    }
    return work;
}

template <int Nodes>
auto InterpolatedRod<Nodes>::compute_damping_tangents(const LocalMotion<Nodes>& motion,
                                                      const LocalMotion<Nodes>& rates,
                                                      Histories histories) const -> DampingTangents {
    DampingTangents tangents{NodalMatrix<Nodes>::Zero(), NodalMatrix<Nodes>::Zero()};
    for (int p = 0; p < point_count; ++p) {
        const Mat6 viscosity = section(p).kelvin_voigt * stiffness(p);
        const ForcePoint point = force_point(p);
        const SectionHistory& history = histories[p];
        const SectionFields fields = interpolate(point, motion);
        const StrainGradient E_u = compute_strain_gradient(fields, history);
        const StrainGradient Z = compute_strain_rate_gradient(fields, interpolate(point, rates), history);
        const Vec6 resultants = viscosity * compute_strain_rates(point, motion, rates, history);
        add_matrix(point,
                   E_u.transpose() * viscosity * Z + compute_geometric_hessian(fields, history, resultants),
                   tangents.by_motion);
        add_matrix(point, E_u.transpose() * viscosity * E_u, tangents.by_rates);
    }
    return tangents;
}

template <int Nodes>
void InterpolatedRod<Nodes>::advance(const LocalMotion<Nodes>& motion,
                                     std::span<SectionHistory> histories) const {
    for (int p = 0; p < point_count; ++p) {
        const SectionFields fields = interpolate(force_point(p), motion);
        histories[p] = {compute_section_axes(fields.theta, histories[p]).normalized(),
                        compute_total_curvature(fields, histories[p])};
    }
}

template <int Nodes>
auto InterpolatedRod<Nodes>::compute_section_state(int p,
                                                   const LocalMotion<Nodes>& motion,
                                                   const LocalMotion<Nodes>& rates,
                                                   Histories histories) const -> SectionState {
    const ForcePoint point = force_point(p);
    SectionState state;
    state.strain = compute_strain(interpolate(point, motion), histories[p], point.reference);
    state.resultants = stiffness(p) * state.strain;
    if (is_damped()) {
        const Vec6 strain_rates = compute_strain_rates(point, motion, rates, histories[p]);
        state.resultants += section(p).kelvin_voigt * (stiffness(p) * strain_rates);
    }
    return state;
}

template <int Nodes>
auto InterpolatedRod<Nodes>::compute_middle_state(const LocalMotion<Nodes>& motion,
                                                  const LocalMotion<Nodes>& rates,
                                                  Histories histories) const -> SectionState {
    constexpr int first = (point_count - 1) / 2;
    constexpr int last = point_count / 2;
    SectionState middle = compute_section_state(first, motion, rates, histories);
    if constexpr (first != last) {
        const SectionState other = compute_section_state(last, motion, rates, histories);
        middle.strain = 0.5 * (middle.strain + other.strain);
        middle.resultants = 0.5 * (middle.resultants + other.resultants);
    }
    return middle;
}

// The strains follow from the resultants but for those of damping, which are known at the points alone.
template <int Nodes>
auto InterpolatedRod<Nodes>::interpolate_state(const LocalMotion<Nodes>& motion,
                                               const LocalMotion<Nodes>& rates,
                                               Histories histories,
                                               const std::array<Vec6, 2>& end_resultants,
                                               const Mat6& stiffness_there,
                                               double xi) const -> SectionState {
    const auto rule = compute_gauss_rule<point_count>();
    NodeValues<point_count> inside;
    NodeValues<point_count + 2> all;
    for (int p = 0; p < point_count; ++p) inside[p] = all[p] = rule[p].xi;
    all[point_count] = -1.0;
    all[point_count + 1] = 1.0;
    const NodeValues<point_count> of_damping = compute_lagrange<point_count>(inside, xi);
    const NodeValues<point_count + 2> of_resultants = compute_lagrange<point_count + 2>(all, xi);

    SectionState state;
    state.resultants =
        of_resultants[point_count] * end_resultants[0] + of_resultants[point_count + 1] * end_resultants[1];
    Vec6 damping = Vec6::Zero();
    for (int p = 0; p < point_count; ++p) {
        const SectionState point = compute_section_state(p, motion, rates, histories);
        state.resultants += of_resultants[p] * point.resultants;
        if (is_damped()) damping += of_damping[p] * (point.resultants - stiffness(p) * point.strain);
    }
    state.strain = stiffness_there.ldlt().solve(state.resultants - damping);
    return state;
}

template class InterpolatedRod<2>;
template class InterpolatedRod<3>;
template class InterpolatedRod<4>;
template class InterpolatedRod<5>;

}  // namespace gxrod
