#pragma once

#include "elements/bushing_base.hpp"
#include "elements/carried_bushing_motion.hpp"

namespace gxrod {

// A bushing whose axes one end, or the ground, carries.
template <int Nodes>
class CarriedBushingElement : public BushingBase<Nodes, CarriedBushingElement<Nodes>, CarriedBushingMotion> {
  public:
    explicit CarriedBushingElement(const Bushing& bushing);

    double damping_action(const Motions<Nodes>& before, const Motions<Nodes>& after, Histories) const;
    // Returns the angle that the stiffness resists: if rotations about one axis are free, the angle of the
    // swing.
    double largest_relative_rotation(const Motions<Nodes>& motions) const;
    // The ground also takes part of the moments if it carries the axes.
    bool leans_on_ground() const { return Nodes == 1 || bushing_.carrier == BushingAxes::ground; }

  private:
    using Base = BushingBase<Nodes, CarriedBushingElement, CarriedBushingMotion>;
    friend Base;
    using Base::bushing_;
    using Base::points_;
    using typename Base::Columns;
    using typename Base::OwnForce;
    using typename Base::StrainColumns;

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
    // Adds the tangent of a force and a moment.
    void add_tangent(const Motions<Nodes>& motions,
                     const CarriedBushingMotion& motion,
                     const Linearizations<Nodes>& linear,
                     const Variation& variation,
                     const OwnForce& own,
                     NodalMatrix<Nodes>& tangent) const;
    // Returns the derivatives of the moments on A and B.
    std::array<Columns, 2> differentiate_moments_on_ends(const Motions<Nodes>& motions,
                                                         const CarriedBushingMotion& motion,
                                                         const Linearizations<Nodes>& linear,
                                                         const Variation& variation,
                                                         const Vec3& own,
                                                         const StrainColumns& derivative) const;

    BushingTurn turn_;
};

extern template class CarriedBushingElement<1>;
extern template class CarriedBushingElement<2>;

static_assert(Element<CarriedBushingElement<1>>);
static_assert(Element<CarriedBushingElement<2>>);

}  // namespace gxrod
