#include "elements/rod/interpolated_rod.hpp"

#include <algorithm>

#include "elements/rod/tendon_force.hpp"

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

// Eᵀ D E + G(S).
Mat9 compute_hessian_density(const SectionFields& fields,
                             const SectionHistory& history,
                             const StrainGradient& E_u,
                             const Vec6& resultants,
                             const Mat6& stiffness) {
    const StrainGradient D_E_u = stiffness * E_u;
    return E_u.transpose() * D_E_u + compute_geometric_hessian(fields, history, resultants);
}

}  // namespace

template <int Nodes>
InterpolatedRod<Nodes>::InterpolatedRod(const LocalMotion<Nodes>& start,
                                        const PointHistories& histories,
                                        const PointSections& sections,
                                        const PointStrains& strains)
    : sections_(sections) {
    for (int p = 0; p < point_count; ++p) {
        points_[p].jacobian = (start.r * point_shape<Nodes>(p).slope).norm();
        // Of this very interpolation, so that the start has the strains to round-off.
        const ReferenceStrain none{Vec3::Zero(), Vec3::Zero()};
        const Vec6 strain =
            compute_strain(interpolate(force_point(p), start), histories[p], none) - strains[p];
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
SectionResponse InterpolatedRod<Nodes>::respond(int p,
                                                const Vec6& strain,
                                                Histories histories,
                                                std::span<double> after) const {
    const RodSection& own = section(p);
    const bool is_driven = !histories.drives.empty();
    const Vec6 of_law = is_driven ? Vec6(strain - histories.drives[p].strain) : strain;
    SectionResponse response;
    if (own.law) {
        const auto first = static_cast<std::size_t>(count_memory_before(p));
        const auto size = static_cast<std::size_t>(own.memory_size());
        const auto part = [&](auto memory) { return memory.empty() ? memory : memory.subspan(first, size); };
        response = own.law->respond(of_law, part(histories.memory), histories.elapsed, part(after));
    } else {
        response.resultants = own.stiffness * of_law;
        response.tangent = own.stiffness;
        response.stored = 0.5 * of_law.dot(response.resultants);
    }
    if (is_driven && !histories.drives[p].pulls.empty()) {
        const Vec6 total = compute_total_strain(p, strain);
        for (const TendonPull& pull : histories.drives[p].pulls)
            add_pull(pull, total, response.resultants, &response.tangent);
    }
    return response;
}

template <int Nodes>
Vec6 InterpolatedRod<Nodes>::compute_total_strain(int p, const Vec6& strain) const {
    Vec6 total = strain;
    total.head<3>() += points_[p].strain.Gamma;
    total.tail<3>() += points_[p].strain.Kappa;
    return total;
}

template <int Nodes>
void InterpolatedRod<Nodes>::add_driven_points(const LocalMotion<Nodes>& motion,
                                               Histories histories,
                                               std::vector<DrivenPoint>& points) const {
    for (int p = 0; p < point_count; ++p) {
        const ForcePoint point = force_point(p);
        const Vec6 strain = compute_strain(interpolate(point, motion), histories.axes[p], point.reference);
        const PointDrive& drive = histories.drives[p];
        DrivenPoint& driven = points.emplace_back();
        driven.weight = point.weight;
        driven.strain = drive.strain;
        driven.resultants = respond(p, strain, histories).resultants;
        for (const TendonPull& pull : drive.pulls) {
            Vec6 of_pull = Vec6::Zero();
            add_pull(pull, compute_total_strain(p, strain), of_pull, nullptr);
            driven.resultants -= of_pull;
            driven.pulls.push_back(
                {pull.tension, compute_tendon_stretch(pull, compute_total_strain(p, strain))});
        }
    }
}

template <int Nodes>
Vec6 InterpolatedRod<Nodes>::compute_resultants(int p, const Vec6& strain, Histories histories) const {
    if (is_linear(histories)) return stiffness(p) * strain;
    return respond(p, strain, histories).resultants;
}

template <int Nodes>
double InterpolatedRod<Nodes>::strain_energy(const LocalMotion<Nodes>& motion, Histories histories) const {
    double energy = 0.0;
    for (int p = 0; p < point_count; ++p) {
        const ForcePoint point = force_point(p);
        const Vec6 strain = compute_strain(interpolate(point, motion), histories.axes[p], point.reference);
        energy += point.weight * (is_linear(histories) ? 0.5 * strain.dot(stiffness(p) * strain)
                                                       : respond(p, strain, histories).stored);
    }
    return energy;
}

template <int Nodes>
double InterpolatedRod<Nodes>::dissipated_energy(const LocalMotion<Nodes>& motion,
                                                 Histories histories) const {
    double energy = 0.0;
    for (int p = 0; p < point_count; ++p) {
        const ForcePoint point = force_point(p);
        const Vec6 strain = compute_strain(interpolate(point, motion), histories.axes[p], point.reference);
        energy += point.weight * respond(p, strain, histories).dissipated;
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
        const Vec6 resultants =
            compute_resultants(p, compute_strain(fields, histories.axes[p], point.reference), histories);
        add_force(
            point, compute_strain_gradient(fields, histories.axes[p]).transpose() * resultants, gradient);
    }
    return gradient;
}

template <int Nodes>
auto InterpolatedRod<Nodes>::compute_derivatives(const LocalMotion<Nodes>& motion, Histories histories) const
    -> Derivatives {
    Derivatives derivatives{NodalVector<Nodes>::Zero(), NodalMatrix<Nodes>::Zero()};
    const auto add = [&](const ForcePoint& point,
                         const SectionFields& fields,
                         const SectionHistory& history,
                         const Vec6& resultants,
                         const Mat6& stiffness) {
        const StrainGradient E_u = compute_strain_gradient(fields, history);
        add_force(point, E_u.transpose() * resultants, derivatives.gradient);
        add_matrix(
            point, compute_hessian_density(fields, history, E_u, resultants, stiffness), derivatives.hessian);
    };
    for (int p = 0; p < point_count; ++p) {
        const ForcePoint point = force_point(p);
        const SectionFields fields = interpolate(point, motion);
        const SectionHistory& history = histories.axes[p];
        const Vec6 strain = compute_strain(fields, history, point.reference);
        if (is_linear(histories)) {
            add(point, fields, history, stiffness(p) * strain, stiffness(p));
        } else {
            const SectionResponse response = respond(p, strain, histories);
            add(point, fields, history, response.resultants, response.tangent);
        }
    }
    return derivatives;
}

template <int Nodes>
NodalVector<Nodes> InterpolatedRod<Nodes>::compute_force_of(const LocalMotion<Nodes>& motion,
                                                            Histories histories,
                                                            Resultants resultants) const {
    NodalVector<Nodes> force = NodalVector<Nodes>::Zero();
    for (int p = 0; p < point_count; ++p) {
        const ForcePoint point = force_point(p);
        const StrainGradient E_u = compute_strain_gradient(interpolate(point, motion), histories.axes[p]);
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
        const SectionFields fields = interpolate(point, motion);
        const StrainGradient E_u = compute_strain_gradient(fields, histories.axes[p]);
        const Mat6 stiffness = compute_stiffness(p, fields, histories);
        add_matrix(point,
                   compute_hessian_density(fields, histories.axes[p], E_u, resultants[p], stiffness),
                   hessian);
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
        const Vec6 strain = compute_strain(interpolate(point, motion), histories.axes[p], point.reference);
        const Vec6 change = compute_strain_rates(point, motion, increment, histories.axes[p]);
        resultants[p] = advance_resultants(p, strain, change, histories);
    }
}

template <int Nodes>
Vec6 InterpolatedRod<Nodes>::advance_resultants(int p,
                                                const Vec6& strain,
                                                const Vec6& change,
                                                Histories histories) const {
    if (is_linear(histories)) return stiffness(p) * (strain + change);
    const SectionResponse response = respond(p, strain, histories);
    return response.resultants + response.tangent * change;
}

template <int Nodes>
Mat6 InterpolatedRod<Nodes>::compute_stiffness(int p,
                                               const SectionFields& fields,
                                               Histories histories) const {
    if (is_linear(histories)) return stiffness(p);
    return respond(p, compute_strain(fields, histories.axes[p], points_[p].strain), histories).tangent;
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
        const Vec6 resultants = section(p).compute_viscous_resultants(
            compute_strain_rates(point, motion, rates, histories.axes[p]));
        const StrainGradient E_u = compute_strain_gradient(interpolate(point, motion), histories.axes[p]);
        add_force(point, E_u.transpose() * resultants, force);
    }
    return force;
}

template <int Nodes>
double InterpolatedRod<Nodes>::damping_action(const Vec6& change) const {
    return force_point(0).weight * change.dot(section(0).compute_viscous_resultants(change));
}

template <int Nodes>
double InterpolatedRod<Nodes>::damping_action(const LocalMotion<Nodes>& previous,
                                              const LocalMotion<Nodes>& trial,
                                              Histories histories) const {
    double action = 0.0;
    for (int p = 0; p < point_count; ++p) {
        const ForcePoint point = force_point(p);
        const Vec6 change = compute_strain(interpolate(point, trial), histories.axes[p], point.reference) -
                            compute_strain(interpolate(point, previous), histories.axes[p], point.reference);
        action += point.weight * change.dot(section(p).compute_viscous_resultants(change));
    }
    return action;
}

template <int Nodes>
Vec6 InterpolatedRod<Nodes>::compute_strain_work(const Vec6& change, const Mat6& stiffness) const {
    return force_point(0).weight * change.cwiseProduct(stiffness * change);
}

template <int Nodes>
Vec6 InterpolatedRod<Nodes>::compute_strain_work(const LocalMotion<Nodes>& motion,
                                                 const LocalMotion<Nodes>& increment,
                                                 Histories histories) const {
    Vec6 work = Vec6::Zero();
    for (int p = 0; p < point_count; ++p) {
        const ForcePoint point = force_point(p);
        const Vec6 change = compute_strain_rates(point, motion, increment, histories.axes[p]);
        const SectionFields fields = interpolate(point, motion);
        work += point.weight * change.cwiseProduct(compute_stiffness(p, fields, histories) * change);
    }
    return work;
}

template <int Nodes>
auto InterpolatedRod<Nodes>::compute_damping_tangents(const LocalMotion<Nodes>& motion,
                                                      const LocalMotion<Nodes>& rates,
                                                      Histories histories) const -> DampingTangents {
    DampingTangents tangents{NodalMatrix<Nodes>::Zero(), NodalMatrix<Nodes>::Zero()};
    for (int p = 0; p < point_count; ++p) {
        const Mat6 viscosity = section(p).compute_viscosity();
        const ForcePoint point = force_point(p);
        const SectionHistory& history = histories.axes[p];
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
void InterpolatedRod<Nodes>::advance(const LocalMotion<Nodes>& motion, std::span<SectionHistory> axes) const {
    for (int p = 0; p < point_count; ++p) {
        const SectionFields fields = interpolate(force_point(p), motion);
        axes[p] = {compute_section_axes(fields.theta, axes[p]).normalized(),
                   compute_total_curvature(fields, axes[p])};
    }
}

template <int Nodes>
void InterpolatedRod<Nodes>::advance_memory(const LocalMotion<Nodes>& motion,
                                            Histories histories,
                                            std::span<double> memory) const {
    std::vector<double> after(memory.size());
    for (int p = 0; p < point_count; ++p) {
        const ForcePoint point = force_point(p);
        respond(p,
                compute_strain(interpolate(point, motion), histories.axes[p], point.reference),
                histories,
                after);
    }
    std::copy(after.begin(), after.end(), memory.begin());
}

template <int Nodes>
auto InterpolatedRod<Nodes>::compute_section_state(int p,
                                                   const LocalMotion<Nodes>& motion,
                                                   const LocalMotion<Nodes>& rates,
                                                   Histories histories) const -> SectionState {
    const ForcePoint point = force_point(p);
    SectionState state;
    state.strain = compute_strain(interpolate(point, motion), histories.axes[p], point.reference);
    state.resultants = compute_resultants(p, state.strain, histories);
    if (is_damped()) {
        const Vec6 strain_rates = compute_strain_rates(point, motion, rates, histories.axes[p]);
        state.resultants += section(p).compute_viscous_resultants(strain_rates);
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

// The strains follow from the resultants but for those of damping, which are known at the points alone, and
// so are the strains themselves of a section that is not linear.
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
    Vec6 strain = Vec6::Zero();
    for (int p = 0; p < point_count; ++p) {
        const SectionState point = compute_section_state(p, motion, rates, histories);
        state.resultants += of_resultants[p] * point.resultants;
        if (is_damped()) damping += of_damping[p] * (point.resultants - stiffness(p) * point.strain);
        strain += of_damping[p] * point.strain;
    }
    state.strain =
        is_linear(histories) ? Vec6(stiffness_there.ldlt().solve(state.resultants - damping)) : strain;
    return state;
}

template class InterpolatedRod<2>;
template class InterpolatedRod<3>;
template class InterpolatedRod<4>;
template class InterpolatedRod<5>;

}  // namespace gxrod
