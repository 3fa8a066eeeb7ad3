#pragma once

#include "elements/bushing_motion.hpp"
#include "elements/plain_element.hpp"
#include "elements/point_pair.hpp"

namespace gxrod {

// A bushing between two points, each carried by a node or fixed, without inertia. With one node it lies
// between the ground and its node.
template <int Nodes>
class BushingElement : public PlainElement<Nodes> {
  public:
    // One of the bushing's ends is the ground if this has one node.
    explicit BushingElement(const Bushing& bushing);

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
    // Returns the rotation of B against A.
    double largest_relative_rotation(const Motions<Nodes>& motions) const;
    double strain_energy(const Motions<Nodes>& motions, Histories) const;

  private:
    using Columns = typename PointPair<Nodes>::Columns;
    using StrainColumns = Eigen::Matrix<double, 6, 6 * Nodes>;

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
    StrainColumns differentiate_strain_rate(const Motions<Nodes>& motions,
                                            const BushingMotion& motion,
                                            const Linearizations<Nodes>& linear,
                                            const Variation& variation) const;
    // Adds the tangent of a force and a moment in the bushing's axes, whose derivative is given.
    void add_tangent(const Motions<Nodes>& motions,
                     const BushingMotion& motion,
                     const Linearizations<Nodes>& linear,
                     const Variation& variation,
                     const Vec6& own,
                     const StrainColumns& derivative,
                     NodalMatrix<Nodes>& tangent) const;

    Bushing bushing_;
    PointPair<Nodes> points_;
};

extern template class BushingElement<1>;
extern template class BushingElement<2>;

static_assert(Element<BushingElement<1>>);
static_assert(Element<BushingElement<2>>);

}  // namespace gxrod
