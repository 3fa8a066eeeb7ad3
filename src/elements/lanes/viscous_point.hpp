#pragma once

#include "elements/lanes/general_rows.hpp"
#include "elements/lanes/lane_products.hpp"
#include "rotation/cross_products.hpp"

namespace gxrod {

// The contribution of Kelvin-Voigt damping to the tangent at one point of the quadrature, in addition to the
// resultants that turn with the motion (docs/theory/rods.md, (R44)–(R47)).
//
// Legend, spatial: δΓ = Λᵀ (N_J′ δr_J + e_J δφ_J), δK = Λᵀ k_J δφ_J, summed over the nodes, are the strains'
// increments, and with v_J and ω_J their rates. °e and °k are rates of e and k, relative to the section on
// the side of the strains and to the frame of the element on the side of the nodes.
template <int Nodes, class Real>
struct ViscousPoint {
    using Vec3 = Eigen::Matrix<Real, 3, 1>;
    using Mat3 = Eigen::Matrix<Real, 3, 3>;
    using Tangent = Eigen::Matrix<Real, 6 * Nodes, 6 * Nodes>;

    Mat3 C_nn, C_nm, C_mm;           // the section's viscosity Λ τC Λᵀ, times the weight
    std::array<Real, Nodes> slopes;  // dN_I/ds
    std::array<Mat3, Nodes> e, k, e_rate, k_rate;
    Vec3 omega;    // spin of the section
    Vec3 omega_R;  // spin of the element's frame

    // Sets the viscosity to `factor` × τC.
    void set_viscosity(
        const Real& factor, const Mat3& Lambda, const Mat3& C_NN, const Mat3& C_NM, const Mat3& C_MM) {
        const Mat3 Lambda_transposed = transpose(Lambda);
        const Mat3 turning = factor * Lambda;
        C_nn = multiply(multiply(turning, C_NN), Lambda_transposed);
        C_nm = multiply(multiply(turning, C_NM), Lambda_transposed);
        C_mm = multiply(multiply(turning, C_MM), Lambda_transposed);
    }

    void add_tangent(const NodeRates<Nodes, Real>& rates,
                     const NodeLinearizations<Nodes, Real>& linearizations,
                     Tangent& tangent) const {
        std::array<Mat3, Nodes> e_transposed, k_transposed;
        for (int i = 0; i < Nodes; ++i) {
            e_transposed[i] = transpose(e[i]);
            k_transposed[i] = transpose(k[i]);
        }
        const Mat3 C_mn = transpose(C_nm);
        add_by_displacements(linearizations, e_transposed, k_transposed, C_mn, tangent);
        for (int j = 0; j < Nodes; ++j) {
            const Real& placement = linearizations.placement[j];
            const Mat3 by_spin =
                linearizations.d_omega[j] + cross_matrix<Real>(placement * (rates.omega[j] - omega_R));
            const Mat3 Gamma = placement * e_rate[j] + multiply(e[j], by_spin);
            const Mat3 Kappa = placement * k_rate[j] + multiply(k[j], by_spin);
            const Mat3 n = multiply(C_nn, Gamma, C_nm, Kappa);
            const Mat3 m = multiply(C_mn, Gamma, C_mm, Kappa);
            for (int i = 0; i < Nodes; ++i) {
                add_block<Real>(slopes[i] * n, 6 * i, 6 * j + 3, tangent);
                add_block(multiply(e_transposed[i], n, k_transposed[i], m), 6 * i + 3, 6 * j + 3, tangent);
            }
        }
    }

  private:
    // Adds the terms of δΓ̇ = Λᵀ N_J′ (rate − placement [ω]×) δr_J.
    void add_by_displacements(const NodeLinearizations<Nodes, Real>& linearizations,
                              const std::array<Mat3, Nodes>& e_transposed,
                              const std::array<Mat3, Nodes>& k_transposed,
                              const Mat3& C_mn,
                              Tangent& tangent) const {
        std::array<Real, Nodes> by_rate, by_placement;
        for (int j = 0; j < Nodes; ++j) {
            by_rate[j] = slopes[j] * linearizations.rate[j];
            by_placement[j] = -slopes[j] * linearizations.placement[j];
        }
        const Mat3 n_omega = cross_rows(C_nn, omega);
        for (int i = 0; i < Nodes; ++i) {
            const Mat3 m = multiply(e_transposed[i], C_nn, k_transposed[i], C_mn);
            const Mat3 m_omega = cross_rows(m, omega);
            for (int j = 0; j < Nodes; ++j) {
                add_block(mix<Real>(slopes[i] * by_rate[j], C_nn, slopes[i] * by_placement[j], n_omega),
                          6 * i,
                          6 * j,
                          tangent);
                add_block(mix(by_rate[j], m, by_placement[j], m_omega), 6 * i + 3, 6 * j, tangent);
            }
        }
    }
};

}  // namespace gxrod
