#pragma once

#include "elements/bushing_base.hpp"
#include "elements/bushing_motion.hpp"

namespace gxrod {

// A bushing whose axes lie half way between those that its ends carry.
template <int Nodes>
class BushingElement : public BushingBase<Nodes, BushingElement<Nodes>, BushingMotion> {
  public:
    explicit BushingElement(const Bushing& bushing);

    double damping_action(const Motions<Nodes>& before, const Motions<Nodes>& after, Histories) const;
    // Returns the rotation of B against A.
    double largest_relative_rotation(const Motions<Nodes>& motions) const;

  private:
    using Base = BushingBase<Nodes, BushingElement, BushingMotion>;
    friend Base;
    using Base::bushing_;
    using Base::points_;
    using typename Base::Columns;
    using typename Base::OwnForce;
    using typename Base::StrainColumns;

    // Derivatives by (δr, δφ) of the nodes.
    struct Variation {
        Columns d;         // spatial
        Columns turn;      // δφ of B less δφ of A
        Columns middle;    // δφ of the axes
        Columns rotation;  // δΦ, in the axes
        Columns tau;       // spatial
    };

    BushingMotion compute_motion(const Motions<Nodes>& motions) const;
    // Adds the nodal forces of a force and a moment in the bushing's axes.
    void add_force(const Motions<Nodes>& motions,
                   const BushingMotion& motion,
                   const Vec6& own,
                   NodalVector<Nodes>& force) const;
    Variation vary(const Motions<Nodes>& motions,
                   const BushingMotion& motion,
                   const Linearizations<Nodes>& linear) const;
    StrainColumns differentiate_strain(const BushingMotion& motion, const Variation& variation) const;
    StrainColumns differentiate_rate(const Motions<Nodes>& motions,
                                     const BushingMotion& motion,
                                     const Linearizations<Nodes>& linear,
                                     const Variation& variation) const;
    // Adds the tangent of a force and a moment.
    void add_tangent(const Motions<Nodes>& motions,
                     const BushingMotion& motion,
                     const Linearizations<Nodes>& linear,
                     const Variation& variation,
                     const OwnForce& own,
                     NodalMatrix<Nodes>& tangent) const;
};

extern template class BushingElement<1>;
extern template class BushingElement<2>;

static_assert(Element<BushingElement<1>>);
static_assert(Element<BushingElement<2>>);

}  // namespace gxrod
