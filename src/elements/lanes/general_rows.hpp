#pragma once

#include <array>

#include "elements/lanes/lanes.hpp"

// What kernels for general sections read beyond those for plain ones (kernels.hpp).
namespace gxrod {

// After the stiffness in the rows of a section: alike in all lanes, so that kernels can branch on it.
template <class Real>
struct GeneralSection {
    static constexpr int first_row = 27;
    static constexpr int rows = 5;

    Eigen::Matrix<Real, 3, 1> centre_of_mass;  // from the node, material
    Real kelvin_voigt, mass_proportional;
    bool has_offset, is_viscous, has_mass_damping;

    explicit GeneralSection(const double* section) {
        const double* row = section + first_row;
        for (int i = 0; i < 3; ++i) centre_of_mass[i] = Real(row[i]);
        kelvin_voigt = Real(row[3]);
        mass_proportional = Real(row[4]);
        has_offset = row[0] != 0.0 || row[1] != 0.0 || row[2] != 0.0;
        is_viscous = row[3] != 0.0;
        has_mass_damping = row[4] != 0.0;
    }
};

// Accelerations less gravity, angular velocities and accelerations, velocities.
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

// Writes the sum, and the largest components of either.
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

// NodeLinearization of each node: what follows `acceleration` is read by itself, since rates lie between.
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
