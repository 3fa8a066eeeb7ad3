#include "elements/rod/simo_element.hpp"

#include "rotation/tangent_map.hpp"

namespace gxrod {

template <int Nodes>
SimoElement<Nodes>::SimoElement(const RodElementGeometry<Nodes>& geometry, const Section& section)
    : nodes(geometry.nodes),
      stiffness_(section.stiffness),
      inertia_(geometry.positions, geometry.triads, section) {
    const auto rule = compute_gauss_rule<Nodes - 1>();
    for (int p = 0; p < force_point_count; ++p) {
        const NodeValues<Nodes> slope = compute_shape_slopes<Nodes>(rule[p].xi);
        Vec3 tangent = Vec3::Zero();
        for (int i = 0; i < Nodes; ++i) tangent += slope[i] * geometry.positions[i];
        const double jacobian = tangent.norm();
        ForcePoint& point = points_[p];
        point.shape = compute_shape_functions<Nodes>(rule[p].xi);
        point.slope = slope / jacobian;
        point.weight = rule[p].weight * jacobian;
        point.axes = geometry.triads[0];
        point.reference.Gamma = point.axes.conjugate() * (tangent / jacobian);
    }
}

template <int Nodes>
SimoFields SimoElement<Nodes>::interpolate(const ForcePoint& point, const Motions<Nodes>& motions) {
    SimoFields fields{Vec3::Zero(), Vec3::Zero(), Vec3::Zero()};
    for (int i = 0; i < Nodes; ++i) {
        fields.r_prime += point.slope[i] * motions[i]->r;
        fields.theta += point.shape[i] * motions[i]->theta;
        fields.theta_prime += point.slope[i] * motions[i]->theta;
    }
    return fields;
}

template <int Nodes>
auto SimoElement<Nodes>::compute_interpolation(const ForcePoint& point) -> Interpolation {
    Interpolation interpolation = Interpolation::Zero();
    for (int i = 0; i < Nodes; ++i) {
        interpolation.template block<3, 3>(0, 6 * i) = point.slope[i] * Mat3::Identity();
        interpolation.template block<3, 3>(3, 6 * i + 3) = point.shape[i] * Mat3::Identity();
        interpolation.template block<3, 3>(6, 6 * i + 3) = point.slope[i] * Mat3::Identity();
    }
    return interpolation;
}

template <int Nodes>
NodalVector<Nodes> SimoElement<Nodes>::compute_energy_gradient(const Motions<Nodes>& motions,
                                                               Histories histories) const {
    NodalVector<Nodes> gradient = NodalVector<Nodes>::Zero();
    for (int p = 0; p < force_point_count; ++p) {
        const ForcePoint& point = points_[p];
        const SimoFields fields = interpolate(point, motions);
        const Vec6 N = stiffness_ * compute_simo_strain(fields, histories[p], point.reference);
        const Vec9 density = compute_strain_gradient(fields, histories[p]).transpose() * N;
        gradient += point.weight * (compute_interpolation(point).transpose() * density);
    }
    return gradient;
}

template <int Nodes>
NodalMatrix<Nodes> SimoElement<Nodes>::compute_energy_hessian(const Motions<Nodes>& motions,
                                                              Histories histories) const {
    NodalMatrix<Nodes> hessian = NodalMatrix<Nodes>::Zero();
    for (int p = 0; p < force_point_count; ++p) {
        const ForcePoint& point = points_[p];
        const SimoFields fields = interpolate(point, motions);
        const Vec6 N = stiffness_ * compute_simo_strain(fields, histories[p], point.reference);
        const auto E_u = compute_strain_gradient(fields, histories[p]);
        const Mat9 density =
            E_u.transpose() * stiffness_ * E_u + compute_geometric_hessian(fields, histories[p], N);
        const Interpolation interpolation = compute_interpolation(point);
        hessian += point.weight * (interpolation.transpose() * density * interpolation);
    }
    return hessian;
}

template <int Nodes>
void SimoElement<Nodes>::add_internal_force(const Motions<Nodes>& motions,
                                            Histories histories,
                                            NodalVector<Nodes>& force) const {
    const NodalVector<Nodes> gradient = compute_energy_gradient(motions, histories);
    for (int i = 0; i < Nodes; ++i) {
        force.template segment<3>(6 * i) += gradient.template segment<3>(6 * i);
        force.template segment<3>(6 * i + 3) +=
            tangent_map_inverse(motions[i]->theta).transpose() * gradient.template segment<3>(6 * i + 3);
    }
}

template <int Nodes>
void SimoElement<Nodes>::add_internal_tangent(const Motions<Nodes>& motions,
                                              Histories histories,
                                              const Linearizations<Nodes>& linearizations,
                                              NodalMatrix<Nodes>& tangent) const {
    const NodalVector<Nodes> gradient = compute_energy_gradient(motions, histories);
    NodalMatrix<Nodes> in_spins = compute_energy_hessian(motions, histories);
    for (int i = 0; i < Nodes; ++i) {
        const Vec3& theta = motions[i]->theta;
        const Mat3 T_inverse = tangent_map_inverse(theta);
        auto columns = in_spins.template middleCols<3>(6 * i + 3);
        columns = (columns * T_inverse).eval();
        auto rows = in_spins.template middleRows<3>(6 * i + 3);
        rows = (T_inverse.transpose() * rows).eval();
        const Vec3 moment = gradient.template segment<3>(6 * i + 3);
        in_spins.template block<3, 3>(6 * i + 3, 6 * i + 3) +=
            tangent_map_inverse_transpose_derivative(theta, moment) * T_inverse;
    }
    for (int i = 0; i < Nodes; ++i) {
        tangent.template middleCols<6>(6 * i) +=
            linearizations[i]->placement * in_spins.template middleCols<6>(6 * i);
    }
}

template <int Nodes>
void SimoElement<Nodes>::add_inertial_force(const Motions<Nodes>& motions,
                                            const Vec3& gravity,
                                            NodalVector<Nodes>& force) const {
    inertia_.add_force(motions, gravity, force);
}

template <int Nodes>
void SimoElement<Nodes>::add_inertial_tangent(const Motions<Nodes>& motions,
                                              const Vec3& gravity,
                                              const Linearizations<Nodes>& linearizations,
                                              NodalMatrix<Nodes>& tangent) const {
    inertia_.add_tangent(motions, gravity, linearizations, tangent);
}

template <int Nodes>
void SimoElement<Nodes>::start(std::span<SectionHistory> histories) const {
    for (int p = 0; p < force_point_count; ++p) histories[p] = {points_[p].axes, points_[p].reference.Kappa};
}

template <int Nodes>
void SimoElement<Nodes>::commit(const Motions<Nodes>& motions, std::span<SectionHistory> histories) const {
    for (int p = 0; p < force_point_count; ++p) {
        const SimoFields fields = interpolate(points_[p], motions);
        histories[p] = {compute_section_axes(fields, histories[p]).normalized(),
                        compute_total_curvature(fields, histories[p])};
    }
}

template <int Nodes>
Vec6 SimoElement<Nodes>::compute_strain(const Motions<Nodes>& motions, Histories histories, int point) const {
    return compute_simo_strain(
        interpolate(points_[point], motions), histories[point], points_[point].reference);
}

template <int Nodes>
SectionValues SimoElement<Nodes>::section_values(const Motions<Nodes>& motions, Histories histories) const {
    constexpr int middle = force_point_count / 2;
    const Vec6 strain = compute_strain(motions, histories, middle);
    const Vec6 resultants = stiffness_ * strain;
    const Quat axes = compute_section_axes(interpolate(points_[middle], motions), histories[middle]);
    return {resultants.head<3>(), resultants.tail<3>(), strain.head<3>(), strain.tail<3>(), axes};
}

template <int Nodes>
double SimoElement<Nodes>::strain_energy(const Motions<Nodes>& motions, Histories histories) const {
    double energy = 0.0;
    for (int p = 0; p < force_point_count; ++p) {
        const Vec6 strain = compute_strain(motions, histories, p);
        energy += 0.5 * points_[p].weight * strain.dot(stiffness_ * strain);
    }
    return energy;
}

template <int Nodes>
double SimoElement<Nodes>::kinetic_energy(const Motions<Nodes>& motions) const {
    return inertia_.kinetic_energy(motions);
}

template <int Nodes>
double SimoElement<Nodes>::gravity_potential(const Motions<Nodes>& motions, const Vec3& gravity) const {
    return inertia_.gravity_potential(motions, gravity);
}

template <int Nodes>
Momentum SimoElement<Nodes>::momentum(const Motions<Nodes>& motions) const {
    return inertia_.momentum(motions);
}

template class SimoElement<2>;

}  // namespace gxrod
