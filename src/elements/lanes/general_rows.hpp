#pragma once

#include <array>

#include "elements/lanes/kernels.hpp"
#include "elements/lanes/lanes.hpp"

// Inputs of kernels for general sections in addition to those for plain ones (kernels.hpp).
namespace gxrod {

// The data of sections; values that are equal in all lanes come first, so that kernels can branch on them.
template <int Nodes, class Real>
struct GeneralSection {
    std::array<Eigen::Matrix<Real, 3, 1>, Nodes> centre_of_mass;  // from each node, material
    Real kelvin_voigt, mass_proportional;
    bool has_offset, is_viscous, has_mass_damping;

    explicit GeneralSection(const double* section) {
        constexpr int stiffness_rows = 27 * (Nodes - 1);
        has_offset = section[0] != 0.0;
        is_viscous = section[1] != 0.0;
        has_mass_damping = section[2] != 0.0;
        kelvin_voigt = Real(section[1]);
        mass_proportional = Real(section[2]);
        LaneReader<Real> read(section + RodKernels<Nodes>::shared_rows +
                              stiffness_rows * static_cast<int>(Real::size));
        for (auto& centre : centre_of_mass) centre = read.vector();
    }
};

// Rates of nodes: accelerations less gravity, angular velocities and accelerations, velocities.
template <int Nodes, class Real>
struct NodeRates {
    using Vectors = std::array<Eigen::Matrix<Real, 3, 1>, Nodes>;

    Vectors a, omega, alpha, v;

    explicit NodeRates(LaneReader<Real>& read) {
        for (Vectors* vectors : {&a, &omega, &alpha, &v}) {
            for (auto& vector : *vectors) vector = read.vector();
        }
    }
};

// Forces and moments on the nodes.
template <int Nodes, class Real>
struct NodeForces {
    std::array<Eigen::Matrix<Real, 3, 1>, Nodes> n, m;

    NodeForces& operator+=(const NodeForces& other) {
        for (int i = 0; i < Nodes; ++i) {
            n[i] += other.n[i];
            m[i] += other.m[i];
        }
        return *this;
    }
};

// Writes the sum, and the largest components of both.
template <int Nodes, class Real>
void write_forces(const NodeForces<Nodes, Real>& internal,
                  const NodeForces<Nodes, Real>& inertial,
                  double* rows) {
    LaneWriter<Real> write(rows);
    Real force_scale(0.0);
    Real moment_scale(0.0);
    for (int i = 0; i < Nodes; ++i) {
        write.matrix(internal.n[i] + inertial.n[i]);
        write.matrix(internal.m[i] + inertial.m[i]);
        force_scale = xsimd::max(force_scale, xsimd::max(largest(internal.n[i]), largest(inertial.n[i])));
        moment_scale = xsimd::max(moment_scale, xsimd::max(largest(internal.m[i]), largest(inertial.m[i])));
    }
    write.scalar(force_scale);
    write.scalar(moment_scale);
}

// NodeLinearization of each node; the part after `acceleration` is read separately, since rates lie between.
template <int Nodes, class Real>
struct NodeLinearizations {
    std::array<Real, Nodes> placement, acceleration, rate;
    std::array<Eigen::Matrix<Real, 3, 3>, Nodes> d_omega, d_alpha;

    explicit NodeLinearizations(LaneReader<Real>& read) {
        for (Real& value : placement) value = read.scalar();
        for (Real& value : acceleration) value = read.scalar();
    }
    void read_rest(LaneReader<Real>& read) {
        for (Real& value : rate) value = read.scalar();
        for (auto& matrix : d_omega) matrix = read.matrix();
        for (auto& matrix : d_alpha) matrix = read.matrix();
    }
};

}  // namespace gxrod
