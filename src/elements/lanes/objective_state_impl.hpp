#pragma once

#include "elements/lanes/objective_state.hpp"

// The functions of ObjectiveState (docs/theory/rods.md, (R13)–(R22)).
namespace gxrod {

template <int Nodes, class Real>
template <class MaybeRates>
auto ObjectiveState<Nodes, Real>::evaluate(const Constants& constants, int p, const MaybeRates& rates) const
    -> Point {
    const auto& [jacobian, Gamma_0, Kappa_0] = constants.points[p];
    const double* shapes = constants.shapes + p * Nodes;
    std::array<Real, Nodes> slopes;
    Vec3 r_prime = Vec3::Constant(Real(0.0));
    Vec3 psi = r_prime;
    Vec3 psi_prime = r_prime;
    for (int i = 0; i < Nodes; ++i) {
        slopes[i] = Real(constants.slopes[p * Nodes + i]) / jacobian;
        r_prime += slopes[i] * rho_[i];
        psi += Real(shapes[i]) * psi_[i];
        psi_prime += slopes[i] * psi_[i];
    }
    const SmallRotation<Real> rotation(psi);
    const Mat3 T = rotation.tangent_map();
    const Mat3 Lambda = rotation.exp() * frame_matrix_;
    Point point{p,
                slopes,
                shapes,
                Real(constants.weights[p]) * jacobian,
                r_prime,
                psi,
                psi_prime,
                rotation,
                T,
                Lambda,
                {},
                {}};
    Vec3 Gamma = Lambda.transpose() * r_prime - Gamma_0;
    Vec3 Kappa = Lambda.transpose() * (T * psi_prime) - Kappa_0;
    if constexpr (std::is_same_v<MaybeRates, Rates>) {
        const PointRates moving = evaluate_rates(point, rates);
        const Vec3 kappa = T * moving.psi_prime + rotation.tangent_map_slope(psi_prime) * moving.psi;
        const Vec3 gamma = moving.r_prime + r_prime.cross(moving.omega);
        Gamma = rates.elasticity * Gamma + rates.viscosity * (Lambda.transpose() * gamma);
        Kappa = rates.elasticity * Kappa + rates.viscosity * (Lambda.transpose() * kappa);
    }
    const auto [C_NN, C_NM, C_MM] = constants.stiffness_of(p);
    point.n = Lambda * (C_NN * Gamma + C_NM * Kappa);
    point.m = Lambda * (C_NM.transpose() * Gamma + C_MM * Kappa);
    return point;
}

// Adds the forces of δW = n · (δr′ + r′ × T δψ) + m · (T δψ′ + T′ δψ).
template <int Nodes, class Real>
void ObjectiveState<Nodes, Real>::add_forces(const Point& point, LocalForces& forces) {
    const Vec3 by_psi =
        point.weight * (point.T.transpose() * point.n.cross(point.r_prime) +
                        point.rotation.tangent_map_slope(point.psi_prime).transpose() * point.m);
    const Vec3 by_slope = point.weight * (point.T.transpose() * point.m);
    const Vec3 n = point.weight * point.n;
    for (int i = 0; i < Nodes; ++i) {
        forces.n[i] += point.slopes[i] * n;
        forces.mu[i] += Real(point.shapes[i]) * by_psi + point.slopes[i] * by_slope;
    }
}

template <int Nodes, class Real>
template <class MaybeRates>
auto ObjectiveState<Nodes, Real>::sum_forces(const Constants& constants, const MaybeRates& rates) const
    -> LocalForces {
    LocalForces forces;
    forces.n.fill(Vec3::Constant(Real(0.0)));
    forces.mu = forces.n;
    for (int p = 0; p < point_count; ++p) add_forces(evaluate(constants, p, rates), forces);
    return forces;
}

// Adds the second derivative of the energy by (ρ_I, ψ_I). Blocks below the diagonal of nodes, and blocks of
// ψ_I by ρ_J, are left out: the whole is symmetric.
template <int Nodes, class Real>
void ObjectiveState<Nodes, Real>::add_stiffness(const Constants& constants,
                                                const Mat3& R,
                                                const Point& point,
                                                Tangent& k) {
    const SmallRotation<Real>& rotation = point.rotation;
    const Vec3 m_R = R * (point.Lambda.transpose() * point.m);  // M turned to the frame
    const Mat3 P = cross_columns(point.r_prime, point.T);
    const Mat3 Q = rotation.tangent_map_slope(point.psi_prime);
    const auto [C_NN, C_NM, C_MM] = constants.stiffness_of(point.index);
    const Mat3 C_nn = point.Lambda * C_NN * point.Lambda.transpose();
    const Mat3 C_nm = point.Lambda * C_NM * point.Lambda.transpose();
    const Mat3 C_mm = point.Lambda * C_MM * point.Lambda.transpose();
    // Derivatives by r′, ψ and ψ′, times the weight.
    const Mat3 n_psi = C_nn * P + C_nm * Q;
    const Mat3 m_psi = C_nm.transpose() * P + C_mm * Q;
    const Mat3 n_slope = C_nm * point.T;
    const Mat3 m_slope = C_mm * point.T;
    const Mat3 spin_n_T = cross_columns(point.n, point.T);
    const Mat3 r_r = point.weight * C_nn;
    const Mat3 r_psi = point.weight * (n_psi - spin_n_T);
    const Mat3 r_slope = point.weight * n_slope;
    const Mat3 psi_psi =
        point.weight * (P.transpose() * n_psi + Q.transpose() * m_psi - P.transpose() * spin_n_T +
                        rotation.tangent_map_transpose_derivative(point.n.cross(point.r_prime)) +
                        rotation.tangent_map_hessian(point.psi_prime, m_R));
    const Mat3 psi_slope = point.weight * (P.transpose() * n_slope + Q.transpose() * m_slope +
                                           rotation.tangent_map_derivative(m_R).transpose());
    const Mat3 slope_slope = point.weight * (point.T.transpose() * m_slope);
    for (int j = 0; j < Nodes; ++j) {
        const Real shape(point.shapes[j]);
        const Real slope = point.slopes[j];
        const Mat3 of_r = shape * r_psi + slope * r_slope;
        const Mat3 of_shape = shape * psi_psi + slope * psi_slope;
        const Mat3 of_slope = shape * psi_slope.transpose() + slope * slope_slope;
        for (int i = 0; i < Nodes; ++i) {
            k.template block<3, 3>(6 * i, 6 * j + 3) += point.slopes[i] * of_r;
            if (i > j) continue;
            k.template block<3, 3>(6 * i, 6 * j) += (point.slopes[i] * slope) * r_r;
            k.template block<3, 3>(6 * i + 3, 6 * j + 3) +=
                Real(point.shapes[i]) * of_shape + point.slopes[i] * of_slope;
        }
    }
}

template <int Nodes, class Real>
auto ObjectiveState<Nodes, Real>::compute_nodal_forces(const LocalForces& local,
                                                       const Inverses& inverses) const -> NodalForces {
    NodalForces forces;
    forces.M.setConstant(Real(0.0));
    for (int i = 0; i < Nodes; ++i) {
        forces.stacked.n[i] = local.n[i];
        forces.stacked.m[i] = inverses[i].tangent_map_inverse().transpose() * local.mu[i];
        forces.M -= rho_[i].cross(local.n[i]) + forces.stacked.m[i];
    }
    if constexpr (has_pair) {
        forces.stacked.m[a] += share(forces.M, 1.0);
        forces.stacked.m[b] += share(forces.M, -1.0);
    } else {
        forces.stacked.m[a] += forces.M;
    }
    return forces;
}

// Turns the second derivative by (ρ, ψ) into the derivative of forces and moments by (δr, δφ), where δρ_I =
// δr_I + ρ_I × δφ_R and δψ_I = T(ψ_I)⁻¹ (δφ_I − δφ_R).
template <int Nodes, class Real>
void ObjectiveState<Nodes, Real>::pull_and_push(const LocalForces& local,
                                                const Inverses& inverses,
                                                Tangent& rows) const {
    const NodalForces forces = compute_nodal_forces(local, inverses);
    FrameRows on_frame = FrameRows::Constant(Real(0.0));
    FrameColumns by_frame;
    std::array<Mat3, Nodes> T_inverse;
    for (int i = 0; i < Nodes; ++i) {
        T_inverse[i] = inverses[i].tangent_map_inverse();
        const Mat3 T_inverse_transposed = T_inverse[i].transpose();
        const Mat3 D = inverses[i].tangent_map_inverse_transpose_derivative(local.mu[i]);
        for (int column = 0; column < 6 * Nodes; ++column) {
            const Vec3 n = rows.template block<3, 1>(6 * i, column);
            const Vec3 mu = rows.template block<3, 1>(6 * i + 3, column);
            const Vec3 m = T_inverse_transposed * mu;
            rows.template block<3, 1>(6 * i + 3, column) = m;
            on_frame.col(column) -= rho_[i].cross(n) + m;
        }
        rows.template block<3, 3>(6 * i + 3, 6 * i + 3) += D;
        on_frame.template middleCols<3>(6 * i + 3) -= D;
        on_frame.template middleCols<3>(6 * i) += cross_matrix(local.n[i]);
        by_frame.template middleRows<3>(6 * i) = -cross_matrix(local.n[i]);
        by_frame.template middleRows<3>(6 * i + 3) = -cross_matrix(forces.stacked.m[i]);
    }
    if constexpr (has_pair) {
        rows.template middleRows<3>(6 * a + 3) += share(on_frame, 1.0);
        rows.template middleRows<3>(6 * b + 3) += share(on_frame, -1.0);
        const Mat3 H = Real(0.5) * cross_columns(forces.M, tau_gradient_);
        rows.template block<3, 3>(6 * a + 3, 6 * a + 3) -= H;
        rows.template block<3, 3>(6 * a + 3, 6 * b + 3) += H;
        rows.template block<3, 3>(6 * b + 3, 6 * a + 3) += H;
        rows.template block<3, 3>(6 * b + 3, 6 * b + 3) -= H;
    } else {
        rows.template middleRows<3>(6 * a + 3) += on_frame;
    }
    for (int i = 0; i < Nodes; ++i) {
        for (int row = 0; row < 6 * Nodes; ++row) {
            const Vec3 by_rho = rows.template block<1, 3>(row, 6 * i).transpose();
            const Vec3 by_psi =
                T_inverse[i].transpose() * rows.template block<1, 3>(row, 6 * i + 3).transpose();
            rows.template block<1, 3>(row, 6 * i + 3) = by_psi.transpose();
            by_frame.row(row) += (by_rho.cross(rho_[i]) - by_psi).transpose();
        }
    }
    if constexpr (has_pair) {
        const Eigen::Matrix<Real, 3, 6 * Nodes> transposed = by_frame.transpose();
        rows.template middleCols<3>(6 * a + 3) += share(transposed, 1.0).transpose();
        rows.template middleCols<3>(6 * b + 3) += share(transposed, -1.0).transpose();
    } else {
        rows.template middleCols<3>(6 * a + 3) += by_frame;
    }
}

template <int Nodes, class Real>
template <class MaybeRates>
void ObjectiveState<Nodes, Real>::compute_tangent(const Constants& constants,
                                                  const MaybeRates& rates,
                                                  Tangent& rows) const {
    rows.setConstant(Real(0.0));
    LocalForces forces;
    forces.n.fill(Vec3::Constant(Real(0.0)));
    forces.mu = forces.n;
    for (int p = 0; p < point_count; ++p) {
        const Point point = evaluate(constants, p, rates);
        add_forces(point, forces);
        add_stiffness(constants, frame_matrix_, point, rows);
    }
    for (int j = 0; j < Nodes; ++j) {
        for (int i = 0; i < Nodes; ++i) {
            rows.template block<3, 3>(6 * j + 3, 6 * i) =
                rows.template block<3, 3>(6 * i, 6 * j + 3).transpose();
            if (i >= j) continue;
            rows.template block<3, 3>(6 * j, 6 * i) = rows.template block<3, 3>(6 * i, 6 * j).transpose();
            rows.template block<3, 3>(6 * j + 3, 6 * i + 3) =
                rows.template block<3, 3>(6 * i + 3, 6 * j + 3).transpose();
        }
    }
    pull_and_push(forces, invert_tangent_maps(), rows);
}

}  // namespace gxrod
