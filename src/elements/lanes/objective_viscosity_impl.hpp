#pragma once

#include "elements/lanes/objective_state.hpp"

// Kelvin-Voigt damping in ObjectiveState (docs/theory/rods.md, (R44)–(R47)). A ° marks rates relative to the
// frame.
namespace gxrod {

template <int Nodes, class Real>
auto ObjectiveState<Nodes, Real>::compute_rates(const NodeRates<Nodes, Real>& nodes) const -> Rates {
    Rates rates;
    rates.omega_R = nodes.omega[a];
    if constexpr (has_pair) {
        const Vec3 difference = nodes.omega[a] - nodes.omega[b];
        rates.omega_R = Real(0.5) * (nodes.omega[a] + nodes.omega[b] + tau_.cross(difference));
    }
    const Inverses inverses = invert_tangent_maps();
    for (int i = 0; i < Nodes; ++i) {
        rates.rho[i] = nodes.v[i] - nodes.v[a] + rho_[i].cross(rates.omega_R);
        rates.psi[i] = inverses[i].tangent_map_inverse() * (nodes.omega[i] - rates.omega_R);
    }
    return rates;
}

template <int Nodes, class Real>
auto ObjectiveState<Nodes, Real>::evaluate_rates(const Point& point, const Rates& rates) const -> PointRates {
    PointRates moving;
    moving.r_prime.setConstant(Real(0.0));
    moving.psi = moving.psi_prime = moving.r_prime;
    for (int i = 0; i < Nodes; ++i) {
        moving.r_prime += point.slopes[i] * rates.rho[i];
        moving.psi += Real(point.shapes[i]) * rates.psi[i];
        moving.psi_prime += point.slopes[i] * rates.psi[i];
    }
    moving.omega = point.T * moving.psi;
    return moving;
}

// Computes the maps without the frame's share: N_I T T_I⁻¹, its derivative by s, and the rates of both.
template <int Nodes, class Real>
auto ObjectiveState<Nodes, Real>::compute_spin_maps(const Point& point,
                                                    const PointRates& moving,
                                                    const InverseMaps& inverses) -> SpinMaps {
    const Mat3 T_slope = point.rotation.tangent_map_slope(point.psi_prime);
    const Mat3 T_rate = point.rotation.tangent_map_slope(moving.psi);
    const Mat3 T_slope_rate =
        point.rotation.tangent_map_slope_rate(point.psi_prime, moving.psi, moving.psi_prime);
    SpinMaps maps;
    for (int i = 0; i < Nodes; ++i) {
        const Real shape(point.shapes[i]);
        const Real& slope = point.slopes[i];
        const Mat3 of_shape = multiply(point.T, inverses.map[i]);
        const Mat3 of_shape_rate = multiply(T_rate, inverses.map[i], point.T, inverses.rate[i]);
        maps.spin[i] = shape * of_shape;
        maps.slope[i] = mix<Real>(slope, of_shape, shape, multiply(T_slope, inverses.map[i]));
        maps.spin_rate[i] = shape * of_shape_rate;
        maps.slope_rate[i] = mix<Real>(
            slope, of_shape_rate, shape, multiply(T_slope_rate, inverses.map[i], T_slope, inverses.rate[i]));
    }
    return maps;
}

// Adds (I − Σ) A_a and (I − Σ) A_b with A_a,b = ½(I ± [τ]×), where Σ are the sums over the nodes.
template <int Nodes, class Real>
void ObjectiveState<Nodes, Real>::share_frame(const Vec3& tau_rate, SpinMaps& maps) const {
    Mat3 spin = -maps.spin[0];
    Mat3 slope = -maps.slope[0];
    Mat3 spin_rate = -maps.spin_rate[0];
    Mat3 slope_rate = -maps.slope_rate[0];
    for (int i = 1; i < Nodes; ++i) {
        spin -= maps.spin[i];
        slope -= maps.slope[i];
        spin_rate -= maps.spin_rate[i];
        slope_rate -= maps.slope_rate[i];
    }
    spin.diagonal().array() += Real(1.0);
    if constexpr (has_pair) {
        const auto share = [&](std::array<Mat3, Nodes>& shared, const Mat3& whole, const Mat3& turned) {
            shared[a] += Real(0.5) * (whole + turned);
            shared[b] += Real(0.5) * (whole - turned);
        };
        share(maps.spin, spin, cross_rows(spin, tau_));
        share(maps.slope, slope, cross_rows(slope, tau_));
        share(maps.spin_rate, spin_rate, cross_rows(spin_rate, tau_) + cross_rows(spin, tau_rate));
        share(maps.slope_rate, slope_rate, cross_rows(slope_rate, tau_) + cross_rows(slope, tau_rate));
    } else {
        maps.spin[a] += spin;
        maps.slope[a] += slope;
        maps.spin_rate[a] += spin_rate;
        maps.slope_rate[a] += slope_rate;
    }
}

template <int Nodes, class Real>
auto ObjectiveState<Nodes, Real>::make_viscous_point(const Constants& constants,
                                                     const Point& point,
                                                     const PointRates& moving,
                                                     const SpinMaps& maps,
                                                     const Rates& rates) -> ViscousPoint<Nodes, Real> {
    ViscousPoint<Nodes, Real> result;
    const auto [C_NN, C_NM, C_MM] = constants.stiffness_of(point.index);
    result.set_viscosity(rates.viscosity * point.weight, point.Lambda, C_NN, C_NM, C_MM);
    result.slopes = point.slopes;
    result.omega_R = rates.omega_R;
    result.omega = rates.omega_R + moving.omega;
    for (int i = 0; i < Nodes; ++i) {
        result.e[i] = cross_columns(point.r_prime, maps.spin[i]);
        result.k[i] = maps.slope[i];
        result.e_rate[i] = cross_columns(moving.r_prime, maps.spin[i]) +
                           cross_columns(point.r_prime, maps.spin_rate[i]) -
                           cross_columns(moving.omega, result.e[i]);
        result.k_rate[i] = maps.slope_rate[i] - cross_columns(moving.omega, result.k[i]);
    }
    return result;
}

template <int Nodes, class Real>
void ObjectiveState<Nodes, Real>::add_viscous_tangent(const Constants& constants,
                                                      const Rates& rates,
                                                      const NodeRates<Nodes, Real>& nodes,
                                                      const NodeLinearizations<Nodes, Real>& linearizations,
                                                      Tangent& tangent) const {
    Vec3 tau_rate = Vec3::Constant(Real(0.0));
    if constexpr (has_pair) tau_rate = tau_gradient_ * (rates.psi[b] - rates.psi[a]);
    const Inverses inverses = invert_tangent_maps();
    InverseMaps inverse_maps;
    for (int i = 0; i < Nodes; ++i) {
        inverse_maps.map[i] = inverses[i].tangent_map_inverse();
        inverse_maps.rate[i] = inverses[i].tangent_map_inverse_rate(rates.psi[i]);
    }
    for (int p = 0; p < point_count; ++p) {
        const Point point = evaluate(constants, p, AtRest());
        const PointRates moving = evaluate_rates(point, rates);
        SpinMaps maps = compute_spin_maps(point, moving, inverse_maps);
        share_frame(tau_rate, maps);
        make_viscous_point(constants, point, moving, maps, rates).add_tangent(nodes, linearizations, tangent);
    }
}

}  // namespace gxrod
