#pragma once

#include <Eigen/Core>

#include "elements/two_point_element.hpp"
#include "model/model.hpp"

namespace gxrod {

// The common part of bushings, whatever carries their axes: linear stiffness and damping of six components.
// `Own` computes the motion, with its strain and rate in the axes, their derivatives by the nodes, and the
// nodal forces of a force and a moment.
template <int Nodes, class Own, class Motion>
class BushingBase : public TwoPointElement<Nodes> {
  public:
    static constexpr bool sees_relative_rotation = true;

    explicit BushingBase(const Bushing& bushing) : TwoPointElement<Nodes>(bushing.ends), bushing_(bushing) {}

    void add_internal_force(const Motions<Nodes>& motions, Histories, NodalVector<Nodes>& force) const {
        const Motion motion = own().compute_motion(motions);
        own().add_force(motions, motion, bushing_.stiffness * motion.strain, force);
    }
    void add_internal_tangent(const Motions<Nodes>& motions,
                              Histories,
                              const Linearizations<Nodes>& linear,
                              NodalMatrix<Nodes>& tangent) const {
        const Motion motion = own().compute_motion(motions);
        const auto variation = own().vary(motions, motion, linear);
        const OwnForce force{bushing_.stiffness * motion.strain,
                             bushing_.stiffness * own().differentiate_strain(motion, variation)};
        own().add_tangent(motions, motion, linear, variation, force, tangent);
    }
    // Adds the internal tangent: there are no force points.
    void add_mixed_tangent(const Motions<Nodes>& motions,
                           Histories histories,
                           Resultants,
                           const Linearizations<Nodes>& linear,
                           NodalMatrix<Nodes>& tangent) const {
        add_internal_tangent(motions, histories, linear, tangent);
    }
    bool is_damped() const { return !bushing_.damping.isZero(0.0); }
    void add_damping_force(const Motions<Nodes>& motions, Histories, NodalVector<Nodes>& force) const {
        if (!is_damped()) return;
        const Motion motion = own().compute_motion(motions);
        own().add_force(motions, motion, bushing_.damping * motion.rate, force);
    }
    void add_damping_tangent(const Motions<Nodes>& motions,
                             Histories,
                             const Linearizations<Nodes>& linear,
                             NodalMatrix<Nodes>& tangent) const {
        if (!is_damped()) return;
        const Motion motion = own().compute_motion(motions);
        const auto variation = own().vary(motions, motion, linear);
        const OwnForce force{bushing_.damping * motion.rate,
                             bushing_.damping * own().differentiate_rate(motions, motion, linear, variation)};
        own().add_tangent(motions, motion, linear, variation, force, tangent);
    }
    double strain_energy(const Motions<Nodes>& motions, Histories) const {
        const Vec6 strain = own().compute_motion(motions).strain;
        return 0.5 * strain.dot(bushing_.stiffness * strain);
    }

  protected:
    using Columns = typename PointPair<Nodes>::Columns;
    using StrainColumns = Eigen::Matrix<double, 6, 6 * Nodes>;
    // A force and a moment in the bushing's axes, and their derivative.
    struct OwnForce {
        Vec6 value;
        StrainColumns derivative;
    };

    Bushing bushing_;

  private:
    const Own& own() const { return static_cast<const Own&>(*this); }
};

}  // namespace gxrod
