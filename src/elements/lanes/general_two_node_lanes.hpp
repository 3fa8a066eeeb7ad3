#pragma once

#include "elements/lanes/centre_inertia.hpp"
#include "elements/lanes/two_node_elements.hpp"
#include "elements/lanes/viscous_point.hpp"

namespace gxrod {

// Elements `objective` with two nodes and general sections.
template <class Real>
class GeneralTwoNodeLanes {
  public:
    static void add_kernels(RodKernels<2>& kernels) {
        kernels.general = {compute_forces, compute_tangents};
        kernels.compute_damping_forces = compute_damping_forces;
    }

  private:
    using Vec3 = Eigen::Matrix<Real, 3, 1>;
    using Mat3 = Eigen::Matrix<Real, 3, 3>;
    using Quat = Eigen::Quaternion<Real>;
    using Rod = TwoNodeRod<Real>;
    using Inertia = CentreInertia<2, Real>;
    using Rates = NodeRates<2, Real>;
    using Tangent = typename Inertia::Tangent;

    // Several elements at the positions of their nodes.
    struct Elements {
        GeneralSection<2, Real> section;
        Rod rod;
        typename Inertia::Mass mass;
        std::array<Quat, 2> axes;
        Vec3 l;
        HalfRotation<Real> rotation;

        Elements(const double* section_rows, const double* constants, LaneReader<Real>& read)
            : section(section_rows) {
            const TwoNodeElements<Real> plain(section_rows, constants);
            rod = plain.rod;
            mass << plain.mass_aa, plain.mass_ab, plain.mass_ab, plain.mass_bb;
            axes[0] = read.quaternion() * plain.triad_a;
            axes[1] = read.quaternion() * plain.triad_b;
            l = read.vector();
            rotation = split_lanes<Real>(axes[0].conjugate() * axes[1]);
        }

        typename Rod::State make_state() const { return {rod, rotation, axes[0], l}; }
        // Computes strain rates times the factor of Kelvin-Voigt damping.
        typename Rod::Strains compute_viscous_strains(const typename Rod::State& state,
                                                      const Rates& rates) const {
            const Real& factor = section.kelvin_voigt;
            return state.compute_strain_increments(
                factor * (rates.v[1] - rates.v[0]), factor * rates.omega[0], factor * rates.omega[1]);
        }
        // Makes the state with damping at these rates.
        typename Rod::State make_state(const Rates& rates) const {
            typename Rod::State state = make_state();
            if (section.is_viscous) {
                const auto [Gamma, Kappa] = compute_viscous_strains(state, rates);
                state.set_resultants(state.compute_resultants_beside(Gamma, Kappa));
            }
            return state;
        }
    };

    static NodeForces<2, Real> gather(const typename Rod::Forces& forces) {
        return {{-forces.n, forces.n}, {forces.moment_a, forces.moment_b}};
    }

    static bool compute_forces(const double* section,
                               const double* constants,
                               const double* motions,
                               double* forces) {
        LaneReader<Real> read(motions);
        const Elements elements(section, constants, read);
        const Rates rates(read);
        const Inertia inertia(elements.section, elements.mass, elements.axes, rates);
        NodeForces<2, Real> internal = gather(elements.make_state(rates).forces());
        if (elements.section.has_mass_damping) internal += inertia.compute_damping_forces();
        write_forces(internal, inertia.compute_inertial_forces(), forces);
        return true;
    }

    static bool compute_damping_forces(const double* section,
                                       const double* constants,
                                       const double* motions,
                                       double* forces) {
        LaneReader<Real> read(motions);
        const Elements elements(section, constants, read);
        const Rates rates(read);
        typename Rod::State state = elements.make_state();
        const typename Rod::Strains viscous = elements.compute_viscous_strains(state, rates);
        state.set_resultants(state.compute_resultants(viscous.Gamma, viscous.Kappa));
        const Inertia inertia(elements.section, elements.mass, elements.axes, rates);
        write_forces(gather(state.forces()), inertia.compute_damping_forces(), forces);
        return true;
    }

    static bool compute_tangents(const double* section,
                                 const double* constants,
                                 const double* motions,
                                 double* tangents) {
        LaneReader<Real> read(motions);
        const Elements elements(section, constants, read);
        NodeLinearizations<2, Real> linearizations(read);
        const Rates rates(read);
        linearizations.read_rest(read);
        const typename Rod::State state = elements.make_state(rates);
        Tangent tangent;
        place(state.compute_tangents(), linearizations.placement, tangent);
        if (elements.section.is_viscous) {
            make_viscous_point(elements, state, rates).add_tangent(rates, linearizations, tangent);
        }
        Inertia(elements.section, elements.mass, elements.axes, rates).add_tangent(linearizations, tangent);
        LaneWriter<Real>(tangents).matrix(tangent);
        return true;
    }

    static void place(const typename Rod::Tangents& t,
                      const std::array<Real, 2>& placement,
                      Tangent& tangent) {
        const auto set = [&](int row, const Mat3& by_u, const Mat3& by_a, const Mat3& by_b) {
            tangent.template block<3, 3>(row, 0) = -placement[0] * by_u;
            tangent.template block<3, 3>(row, 3) = placement[0] * by_a;
            tangent.template block<3, 3>(row, 6) = placement[1] * by_u;
            tangent.template block<3, 3>(row, 9) = placement[1] * by_b;
        };
        set(0, -t.n_u, -t.n_a, -t.n_b);
        set(3, t.a_u, t.a_a, t.a_b);
        set(6, t.n_u, t.n_a, t.n_b);
        set(9, t.b_u, t.b_a, t.b_b);
    }

    // Makes the point with e_J = [l]× A_J/L and k_b = X/L = −k_a; the section is the frame.
    static ViscousPoint<2, Real> make_viscous_point(const Elements& elements,
                                                    const typename Rod::State& state,
                                                    const Rates& rates) {
        const Rod& rod = elements.rod;
        const HalfRotation<Real>& rotation = elements.rotation;
        const Vec3& phi = state.phi();
        const Real per_length = Real(1.0) / rod.length;
        ViscousPoint<2, Real> point;
        point.set_viscosity(
            elements.section.kelvin_voigt * rod.length, state.frame(), rod.C_NN, rod.C_NM, rod.C_MM);
        point.slopes = {-per_length, per_length};
        point.omega = point.omega_R = state.compute_frame_spin(rates.omega[0], rates.omega[1]);
        const Vec3 phi_rate = state.compute_phi_increment(rates.omega[0], rates.omega[1]);
        const Real along = phi.dot(phi_rate);
        const Vec3 tau_rate = rotation.t * phi_rate + (rotation.t1 * along) * phi;
        // [l]× A_a,b = ½ ([l]× ± [l]× [τ]×), and X.
        const Vec3 l = per_length * elements.l;
        const Vec3 l_rate = per_length * (rates.v[1] - rates.v[0]) - point.omega.cross(l);
        const Mat3 turned = cross_columns<Real>(l, cross_matrix(state.tau()));
        const Mat3 turned_rate = cross_columns<Real>(l_rate, cross_matrix(state.tau())) +
                                 cross_columns<Real>(l, cross_matrix(tau_rate));
        point.e[0] = Real(0.5) * (cross_matrix(l) + turned);
        point.e[1] = Real(0.5) * (cross_matrix(l) - turned);
        point.e_rate[0] = Real(0.5) * (cross_matrix(l_rate) + turned_rate);
        point.e_rate[1] = Real(0.5) * (cross_matrix(l_rate) - turned_rate);
        const Vec3 y_phi = (per_length * rotation.y) * phi;
        const Mat3 outer = y_phi * phi_rate.transpose();
        point.k[1] = y_phi * phi.transpose();
        point.k[1].diagonal().array() += per_length * rotation.x;
        point.k_rate[1] =
            outer + outer.transpose() + ((per_length * rotation.y1 * along) * phi) * phi.transpose();
        point.k_rate[1].diagonal().array() += per_length * rotation.x1 * along;
        point.k[0] = -point.k[1];
        point.k_rate[0] = -point.k_rate[1];
        return point;
    }
};

}  // namespace gxrod
