#pragma once

#include "elements/lanes/add_lanes.hpp"
#include "elements/lanes/two_node_elements.hpp"

namespace gxrod {

// Elements `objective` with two nodes and plain sections.
template <class Real>
class TwoNodeLanes {
  public:
    // Makes the kernels without those for general sections.
    static RodKernels<2> make_kernels() {
        return {{compute_forces, compute_tangents}, {}, {}, AddLanes<2, Real>::add_tangents};
    }

  private:
    using Vec3 = Eigen::Matrix<Real, 3, 1>;
    using Mat3 = Eigen::Matrix<Real, 3, 3>;
    using Quat = Eigen::Quaternion<Real>;
    using Rod = TwoNodeRod<Real>;
    using Elements = TwoNodeElements<Real>;

    static bool compute_forces(const double* section,
                               const double* constants,
                               const double* motions,
                               double* forces) {
        const Elements elements(section, constants);
        LaneReader<Real> read(motions);
        const Quat Lambda_a = read.quaternion();
        const Quat Lambda_b = read.quaternion();
        const Vec3 l = read.vector();
        const Vec3 acceleration_a = read.vector();
        const Vec3 acceleration_b = read.vector();
        const Quat axes_a = Lambda_a * elements.triad_a;
        const HalfRotation<Real> rotation =
            split_lanes<Real>(axes_a.conjugate() * (Lambda_b * elements.triad_b));
        const typename Rod::Forces internal = typename Rod::State(elements.rod, rotation, axes_a, l).forces();
        const Vec3 inertial_a = elements.mass_aa * acceleration_a + elements.mass_ab * acceleration_b;
        const Vec3 inertial_b = elements.mass_ab * acceleration_a + elements.mass_bb * acceleration_b;
        LaneWriter<Real> write(forces);
        write.matrix(inertial_a - internal.n);
        write.matrix(internal.moment_a);
        write.matrix(inertial_b + internal.n);
        write.matrix(internal.moment_b);
        write.scalar(xsimd::max(largest(internal.n), xsimd::max(largest(inertial_a), largest(inertial_b))));
        write.scalar(xsimd::max(largest(internal.moment_a), largest(internal.moment_b)));
        return true;
    }

    static bool compute_tangents(const double* section,
                                 const double* constants,
                                 const double* motions,
                                 double* tangents) {
        const Elements elements(section, constants);
        LaneReader<Real> read(motions);
        const Quat Lambda_a = read.quaternion();
        const Quat Lambda_b = read.quaternion();
        const Vec3 l = read.vector();
        const Real placement_a = read.scalar();
        const Real placement_b = read.scalar();
        const Real acceleration_a = read.scalar();
        const Real acceleration_b = read.scalar();
        const Quat axes_a = Lambda_a * elements.triad_a;
        const HalfRotation<Real> rotation =
            split_lanes<Real>(axes_a.conjugate() * (Lambda_b * elements.triad_b));
        const typename Rod::Tangents t =
            typename Rod::State(elements.rod, rotation, axes_a, l).compute_tangents();
        const Mat3 u_aa = add_mass(placement_a * t.n_u, elements.mass_aa * acceleration_a);
        const Mat3 u_ba = add_mass(-placement_a * t.n_u, elements.mass_ab * acceleration_a);
        const Mat3 u_ab = add_mass(-placement_b * t.n_u, elements.mass_ab * acceleration_b);
        const Mat3 u_bb = add_mass(placement_b * t.n_u, elements.mass_bb * acceleration_b);
        LaneWriter<Real> write(tangents);
        write_columns(write, u_aa, -placement_a * t.a_u, u_ba, -placement_a * t.b_u);
        write_columns(
            write, -placement_a * t.n_a, placement_a * t.a_a, placement_a * t.n_a, placement_a * t.b_a);
        write_columns(write, u_ab, placement_b * t.a_u, u_bb, placement_b * t.b_u);
        write_columns(
            write, -placement_b * t.n_b, placement_b * t.a_b, placement_b * t.n_b, placement_b * t.b_b);
        return true;
    }

    static Mat3 add_mass(Mat3 stiffness, const Real& mass) {
        for (int i = 0; i < 3; ++i) stiffness(i, i) += mass;
        return stiffness;
    }

    // Writes three columns of a tangent, from top to bottom.
    static void write_columns(LaneWriter<Real>& write,
                              const Mat3& n_a,
                              const Mat3& moment_a,
                              const Mat3& n_b,
                              const Mat3& moment_b) {
        for (int column = 0; column < 3; ++column) {
            write.matrix(n_a.col(column));
            write.matrix(moment_a.col(column));
            write.matrix(n_b.col(column));
            write.matrix(moment_b.col(column));
        }
    }
};

}  // namespace gxrod
