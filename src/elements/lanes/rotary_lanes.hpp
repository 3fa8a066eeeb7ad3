#pragma once

#include "elements/lanes/kernels.hpp"
#include "elements/lanes/lanes.hpp"
#include "elements/rotary_inertia.hpp"

namespace gxrod {

template <class Real>
class RotaryLanes {
  public:
    static RotaryKernels make_kernels() { return {compute_moments, compute_tangents}; }
    static RotaryKernels make_damping_kernels() { return {compute_momenta, compute_momentum_tangents}; }

  private:
    using Vec3 = Eigen::Matrix<Real, 3, 1>;
    using Mat3 = Eigen::Matrix<Real, 3, 3>;
    using Quat = Eigen::Quaternion<Real>;

    static void compute_moments(const double* constants, const double* motions, double* moments) {
        const Mat3 J_0 = LaneReader<Real>(constants).matrix();
        LaneReader<Real> read(motions);
        const Quat Lambda = read.quaternion();
        const Vec3 omega = read.vector();
        const Vec3 alpha = read.vector();
        LaneWriter<Real>(moments).matrix(RotaryInertia<Real>(J_0, Lambda).compute_moment(omega, alpha));
    }

    static void compute_tangents(const double* constants, const double* motions, double* tangents) {
        const Mat3 J_0 = LaneReader<Real>(constants).matrix();
        LaneReader<Real> read(motions);
        const Quat Lambda = read.quaternion();
        const Vec3 omega = read.vector();
        const Vec3 alpha = read.vector();
        const Real placement = read.scalar();
        const Mat3 d_omega = read.matrix();
        const Mat3 d_alpha = read.matrix();
        LaneWriter<Real>(tangents).matrix(
            RotaryInertia<Real>(J_0, Lambda).compute_tangent(omega, alpha, placement, d_omega, d_alpha));
    }

    static void compute_momenta(const double* constants, const double* motions, double* momenta) {
        const Mat3 J_0 = LaneReader<Real>(constants).matrix();
        LaneReader<Real> read(motions);
        const Quat Lambda = read.quaternion();
        const Vec3 omega = read.vector();
        LaneWriter<Real>(momenta).matrix(RotaryInertia<Real>(J_0, Lambda).compute_momentum(omega));
    }

    static void compute_momentum_tangents(const double* constants, const double* motions, double* tangents) {
        const Mat3 J_0 = LaneReader<Real>(constants).matrix();
        LaneReader<Real> read(motions);
        const Quat Lambda = read.quaternion();
        const Vec3 omega = read.vector();
        read.vector();  // α
        const Real placement = read.scalar();
        const Mat3 d_omega = read.matrix();
        LaneWriter<Real>(tangents).matrix(
            RotaryInertia<Real>(J_0, Lambda).compute_momentum_tangent(omega, placement, d_omega));
    }
};

}  // namespace gxrod
