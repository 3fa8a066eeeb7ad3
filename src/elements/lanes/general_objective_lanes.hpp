#pragma once

#include "elements/lanes/centre_inertia.hpp"
#include "elements/lanes/objective_state.hpp"

namespace gxrod {

// Elements `objective` with three to five nodes and general sections.
template <int Nodes, class Real>
class GeneralObjectiveLanes {
  public:
    static void add_kernels(RodKernels<Nodes>& kernels) {
        kernels.general = {compute_forces, compute_tangents};
        kernels.compute_damping_forces = compute_damping_forces;
    }

  private:
    using State = ObjectiveState<Nodes, Real>;
    using Constants = ObjectiveConstants<Nodes, Real>;
    using Rates = typename State::Rates;
    using Inertia = CentreInertia<Nodes, Real>;

    static Rates find_rates(const GeneralSection<Nodes, Real>& section,
                            const State& state,
                            const NodeRates<Nodes, Real>& nodes,
                            double elasticity) {
        Rates rates = state.compute_rates(nodes);
        rates.elasticity = Real(elasticity);
        rates.viscosity = section.kelvin_voigt;
        return rates;
    }

    static bool compute_forces(const double* section_rows,
                               const double* constant_rows,
                               const double* motions,
                               double* rows) {
        const GeneralSection<Nodes, Real> section(section_rows);
        const Constants constants(section_rows, constant_rows);
        LaneReader<Real> read(motions);
        const ObjectiveMotion<Nodes, Real> motion(constants, read);
        const State state(motion);
        if (!state.is_small()) return false;
        const NodeRates<Nodes, Real> nodes(read);
        const Inertia inertia(section, constants.mass, motion.axes, nodes);
        NodeForces<Nodes, Real> internal =
            section.is_viscous ? state.compute_forces(constants, find_rates(section, state, nodes, 1.0))
                               : state.compute_forces(constants, AtRest());
        if (section.has_mass_damping) internal += inertia.compute_damping_forces();
        write_forces(internal, inertia.compute_inertial_forces(), rows);
        return true;
    }

    static bool compute_damping_forces(const double* section_rows,
                                       const double* constant_rows,
                                       const double* motions,
                                       double* rows) {
        const GeneralSection<Nodes, Real> section(section_rows);
        const Constants constants(section_rows, constant_rows);
        LaneReader<Real> read(motions);
        const ObjectiveMotion<Nodes, Real> motion(constants, read);
        const State state(motion);
        if (!state.is_small()) return false;
        const NodeRates<Nodes, Real> nodes(read);
        const Inertia inertia(section, constants.mass, motion.axes, nodes);
        write_forces(state.compute_forces(constants, find_rates(section, state, nodes, 0.0)),
                     inertia.compute_damping_forces(),
                     rows);
        return true;
    }

    static bool compute_tangents(const double* section_rows,
                                 const double* constant_rows,
                                 const double* motions,
                                 double* rows) {
        const GeneralSection<Nodes, Real> section(section_rows);
        const Constants constants(section_rows, constant_rows);
        LaneReader<Real> read(motions);
        const ObjectiveMotion<Nodes, Real> motion(constants, read);
        const State state(motion);
        if (!state.is_small()) return false;
        NodeLinearizations<Nodes, Real> linearizations(read);
        const NodeRates<Nodes, Real> nodes(read);
        linearizations.read_rest(read);
        typename State::Tangent tangent;
        if (section.is_viscous) {
            const Rates rates = find_rates(section, state, nodes, 1.0);
            state.compute_tangent(constants, rates, tangent);
            place(linearizations, tangent);
            state.add_viscous_tangent(constants, rates, nodes, linearizations, tangent);
        } else {
            state.compute_tangent(constants, AtRest(), tangent);
            place(linearizations, tangent);
        }
        Inertia(section, constants.mass, motion.axes, nodes).add_tangent(linearizations, tangent);
        LaneWriter<Real>(rows).matrix(tangent);
        return true;
    }

    static void place(const NodeLinearizations<Nodes, Real>& linearizations,
                      typename State::Tangent& tangent) {
        for (int column = 0; column < 6 * Nodes; ++column)
            tangent.col(column) *= linearizations.placement[column / 6];
    }
};

}  // namespace gxrod
