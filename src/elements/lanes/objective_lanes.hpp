#pragma once

#include "elements/lanes/add_lanes.hpp"
#include "elements/lanes/objective_state.hpp"

namespace gxrod {

// Elements `objective` with three to five nodes and plain sections.
template <int Nodes, class Real>
class ObjectiveLanes {
  public:
    // Makes the kernels without those for general sections.
    static RodKernels<Nodes> make_kernels() {
        return {{compute_forces, compute_tangents}, {}, {}, AddLanes<Nodes, Real>::add_tangents};
    }

  private:
    using Vec3 = Eigen::Matrix<Real, 3, 1>;
    using State = ObjectiveState<Nodes, Real>;
    using Constants = ObjectiveConstants<Nodes, Real>;
    using Motion = ObjectiveMotion<Nodes, Real>;

    static bool compute_forces(const double* section,
                               const double* constant_rows,
                               const double* motions,
                               double* rows) {
        const Constants constants(section, constant_rows);
        LaneReader<Real> read(motions);
        const Motion motion(constants, read);
        const State state(motion);
        if (!state.is_small()) return false;
        std::array<Vec3, Nodes> accelerations;
        for (Vec3& acceleration : accelerations) acceleration = read.vector();
        const typename State::Forces internal = state.compute_forces(constants, AtRest());
        LaneWriter<Real> write(rows);
        Real force_scale(0.0);
        Real moment_scale(0.0);
        for (int i = 0; i < Nodes; ++i) {
            Vec3 inertial = constants.mass(i, 0) * accelerations[0];
            for (int j = 1; j < Nodes; ++j) inertial += constants.mass(i, j) * accelerations[j];
            write.matrix(internal.n[i] + inertial);
            write.matrix(internal.m[i]);
            force_scale = xsimd::max(force_scale, xsimd::max(largest(internal.n[i]), largest(inertial)));
            moment_scale = xsimd::max(moment_scale, largest(internal.m[i]));
        }
        write.scalar(force_scale);
        write.scalar(moment_scale);
        return true;
    }

    static bool compute_tangents(const double* section,
                                 const double* constant_rows,
                                 const double* motions,
                                 double* rows) {
        const Constants constants(section, constant_rows);
        LaneReader<Real> read(motions);
        const Motion motion(constants, read);
        const State state(motion);
        if (!state.is_small()) return false;
        std::array<Real, Nodes> placements, accelerations;
        for (Real& placement : placements) placement = read.scalar();
        for (Real& acceleration : accelerations) acceleration = read.scalar();
        typename State::Tangent tangent;
        state.compute_tangent(constants, AtRest(), tangent);
        LaneWriter<Real> write(rows);
        for (int column = 0; column < 6 * Nodes; ++column) {
            const int node = column / 6;
            for (int row = 0; row < 6 * Nodes; ++row) {
                Real entry = placements[node] * tangent(row, column);
                if (column % 6 < 3 && row % 6 == column % 6)
                    entry += constants.mass(row / 6, node) * accelerations[node];
                write.scalar(entry);
            }
        }
        return true;
    }
};

}  // namespace gxrod
