#pragma once

#include "elements/spring_line.hpp"
#include "elements/two_point_element.hpp"
#include "model/spring_law.hpp"

namespace gxrod {

// A spring and damper along the line between two points.
template <int Nodes>
class SpringElement : public TwoPointElement<Nodes> {
  public:
    explicit SpringElement(const Spring& spring);

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
    bool is_damped() const { return spring_.damping > 0.0 || (spring_.law && spring_.law->has_rate()); }
    void add_damping_force(const Motions<Nodes>& motions, Histories, NodalVector<Nodes>& force) const;
    void add_damping_tangent(const Motions<Nodes>& motions,
                             Histories,
                             const Linearizations<Nodes>& linearizations,
                             NodalMatrix<Nodes>& tangent) const;
    double damping_action(const Motions<Nodes>& before, const Motions<Nodes>& after, Histories) const;
    double strain_energy(const Motions<Nodes>& motions, Histories) const;

  private:
    using Columns = typename PointPair<Nodes>::Columns;
    using TwoPointElement<Nodes>::points_;

    // Derivatives of the damper's tension.
    struct DamperSlopes {
        double by_length;
        double by_rate;
    };
    DamperSlopes differentiate_damper(const SpringLine& line, const Linearizations<Nodes>& linear) const;
    SpringLine compute_line(const Motions<Nodes>& motions) const;
    // Whether the force is k d, which needs no direction.
    bool is_plain() const { return spring_.length == 0.0 && !spring_.law; }
    // Compute the force on point B, and its derivatives by the line and its rate.
    Vec3 compute_elastic_force(const SpringLine& line) const;
    Mat3 compute_stiffness(const SpringLine& line) const;
    void add_force(const Motions<Nodes>& motions, const Vec3& at_B, NodalVector<Nodes>& force) const;
    // Adds the tangent of a force on point B whose derivative is given.
    void add_tangent(const Motions<Nodes>& motions,
                     const Linearizations<Nodes>& linear,
                     const Vec3& at_B,
                     const Columns& derivative,
                     NodalMatrix<Nodes>& tangent) const;

    Spring spring_;
};

extern template class SpringElement<1>;
extern template class SpringElement<2>;

static_assert(Element<SpringElement<1>>);
static_assert(Element<SpringElement<2>>);

}  // namespace gxrod
