#pragma once

#include "elements/lanes/kernels.hpp"
#include "elements/lanes/lanes.hpp"
#include "elements/rod/two_node_rod.hpp"

namespace gxrod {

// The data of several elements with two nodes, from the rows of RodKernels.
template <class Real>
struct TwoNodeElements {
    using Mat3 = Eigen::Matrix<Real, 3, 3>;
    using Quat = Eigen::Quaternion<Real>;

    TwoNodeRod<Real> rod;
    Quat triad_a, triad_b;
    Real mass_aa, mass_ab, mass_bb;

    TwoNodeElements(const double* section, const double* constants) {
        LaneReader<Real> of_section(section + RodKernels<2>::shared_rows);
        for (Mat3* block : {&rod.C_NN, &rod.C_NM, &rod.C_MM}) *block = of_section.matrix();
        LaneReader<Real> read(constants);
        rod.length = read.scalar();
        rod.Gamma_0 = read.vector();
        rod.Kappa_0 = read.vector();
        triad_a = read.quaternion();
        triad_b = read.quaternion();
        mass_aa = read.scalar();
        mass_ab = read.scalar();
        mass_bb = read.scalar();
    }
};

// Replaces the results of series in lanes that are turned too far for them.
template <class Real>
void fill_large_lanes(const Eigen::Quaternion<Real>& q, const Real& square, HalfRotation<Real>& rotation) {
    constexpr int width = static_cast<int>(Real::size);
    std::array<Real*, half_rotation_values> replaced{&rotation.Phi[0],
                                                     &rotation.Phi[1],
                                                     &rotation.Phi[2],
                                                     &rotation.x,
                                                     &rotation.y,
                                                     &rotation.t,
                                                     &rotation.x1,
                                                     &rotation.y1,
                                                     &rotation.t1};
    double squares[width];
    double quaternions[4 * width];
    double values[half_rotation_values * width];
    square.store_unaligned(squares);
    LaneWriter<Real>(quaternions).matrix(q.coeffs());
    LaneWriter<Real> write(values);
    for (const Real* value : replaced) write.scalar(*value);
    for (int lane = 0; lane < width; ++lane) {
        if (!(squares[lane] < half_rotation::largest_square))
            fill_lane(quaternions + lane, width, values + lane);
    }
    LaneReader<Real> read(values);
    for (Real* value : replaced) *value = read.scalar();
}

// Returns the rotation from a to b, for quaternions of either sign.
template <class Real>
HalfRotation<Real> split_lanes(Eigen::Quaternion<Real> q) {
    HalfRotation<Real> rotation;
    const Real sign = xsimd::select(q.w() < Real(0.0), Real(-1.0), Real(1.0));
    q.coeffs() *= sign;
    split_half(q, rotation);
    fill_small(q, rotation);
    const Real square = q.vec().squaredNorm();
    if (!xsimd::all(square < Real(half_rotation::largest_square))) fill_large_lanes(q, square, rotation);
    return rotation;
}

}  // namespace gxrod
