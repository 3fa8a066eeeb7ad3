#pragma once

#include "elements/carried_bushing_motion.hpp"
#include "elements/plain_element.hpp"
#include "elements/point_pair.hpp"

namespace gxrod {

// A bushing whose axes one end, or the ground, carries, without inertia. With one node it lies between the
// ground and its node.
template <int Nodes>
class CarriedBushingElement : public PlainElement<Nodes> {
  public:
    explicit CarriedBushingElement(const Bushing& bushing);

    void add_internal_force(const Motions<Nodes>& motions, Histories, NodalVector<Nodes>& force) const;
    void add_internal_tangent(const Motions<Nodes>& motions,
                              Histories,
                              const Linearizations<Nodes>& linearizations,
                              NodalMatrix<Nodes>& tangent) const;
    // Adds the internal tangent: there are no force points.
    void add_mixed_tangent(const Motions<Nodes>& motions,
                           Histories histories,
                           Resultants,
                           const Linearizations<Nodes>& linearizations,
                           NodalMatrix<Nodes>& tangent) const {
        add_internal_tangent(motions, histories, linearizations, tangent);
    }
    bool is_damped() const { return !bushing_.damping.isZero(0.0); }
    void add_damping_force(const Motions<Nodes>& motions, Histories, NodalVector<Nodes>& force) const;
    void add_damping_tangent(const Motions<Nodes>& motions,
                             Histories,
                             const Linearizations<Nodes>& linearizations,
                             NodalMatrix<Nodes>& tangent) const;
    double damping_action(const Motions<Nodes>& before, const Motions<Nodes>& after, Histories) const;
    // Returns the angle that the stiffness resists: if rotations about one axis are free, the angle of the
    // swing.
    double largest_relative_rotation(const Motions<Nodes>& motions) const;
    double strain_energy(const Motions<Nodes>& motions, Histories) const;
    // Whether the ground takes part of the moments, although neither end is the ground.
    bool leans_on_ground() const { return bushing_.carrier == BushingAxes::ground; }

  private:
    using Columns = typename PointPair<Nodes>::Columns;
    using StrainColumns = Eigen::Matrix<double, 6, 6 * Nodes>;

    // Derivatives by (δr, δφ) of the nodes, spatial.
    struct Variation {
        Columns d;
        Columns axes;  // spin of the axes
        Columns turn;  // δe
    };

    CarriedBushingMotion compute_motion(const Motions<Nodes>& motions) const;
    std::size_t end_of(int node) const { return points_.sign(node) < 0.0 ? 0 : 1; }
    // Adds the nodal forces of a force and a moment in the axes.
    void add_force(const Motions<Nodes>& motions,
                   const CarriedBushingMotion& motion,
                   const Vec6& own,
                   NodalVector<Nodes>& force) const;
    Variation vary(const Motions<Nodes>& motions,
                   const CarriedBushingMotion& motion,
                   const Linearizations<Nodes>& linear) const;
    StrainColumns differentiate_strain(const CarriedBushingMotion& motion, const Variation& variation) const;
    StrainColumns differentiate_rate(const Motions<Nodes>& motions,
                                     const CarriedBushingMotion& motion,
                                     const Linearizations<Nodes>& linear,
                                     const Variation& variation) const;
    // Adds the tangent of a force and a moment in the axes, whose derivative is given.
    void add_tangent(const Motions<Nodes>& motions,
                     const CarriedBushingMotion& motion,
                     const Linearizations<Nodes>& linear,
                     const Variation& variation,
                     const Vec6& own,
                     const StrainColumns& derivative,
                     NodalMatrix<Nodes>& tangent) const;
    // Returns the derivatives of the moments on A and B.
    std::array<Columns, 2> differentiate_moments_on_ends(const Motions<Nodes>& motions,
                                                         const CarriedBushingMotion& motion,
                                                         const Linearizations<Nodes>& linear,
                                                         const Variation& variation,
                                                         const Vec3& own,
                                                         const StrainColumns& derivative) const;

    Bushing bushing_;
    BushingTurn turn_;
    PointPair<Nodes> points_;
};

extern template class CarriedBushingElement<1>;
extern template class CarriedBushingElement<2>;

static_assert(Element<CarriedBushingElement<1>>);
static_assert(Element<CarriedBushingElement<2>>);

}  // namespace gxrod
