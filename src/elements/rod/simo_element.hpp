#pragma once

#include <vector>

#include "elements/element.hpp"
#include "elements/rod/rod_inertia.hpp"
#include "elements/rod/shape_functions.hpp"
#include "elements/rod/simo_strain.hpp"
#include "model/model.hpp"
#include "state/section_values.hpp"

namespace gxrod {

// What a straight or curved piece of rod is made from: its nodes with position and section axes at t = 0.
template <int Nodes>
struct RodElementGeometry {
    std::array<int, Nodes> nodes;
    std::array<Vec3, Nodes> positions;
    std::array<Quat, Nodes> triads;
};

// Simo & Vu-Quoc's rod element: positions and the rotation vectors θ_I of the step are interpolated,
// θ(s) = Σ N_I θ_I. The force is the gradient of the strain energy in (r_I, θ_I), carried to spins by
// δθ_I = T(θ_I)⁻¹ δφ_I; so test functions are δφ(s) = T(θ(s)) Σ N_I T(θ_I)⁻¹ δφ_I.
// Integrated with Nodes − 1 Gauss points, which does not lock.
template <int Nodes>
class SimoElement {
  public:
    static constexpr int node_count = Nodes;
    static constexpr int force_point_count = Nodes - 1;
    std::array<int, Nodes> nodes;

    SimoElement(const RodElementGeometry<Nodes>& geometry, const Section& section);

    void add_internal_force(const Motions<Nodes>& motions,
                            Histories histories,
                            NodalVector<Nodes>& force) const;
    void add_internal_tangent(const Motions<Nodes>& motions,
                              Histories histories,
                              const Linearizations<Nodes>& linearizations,
                              NodalMatrix<Nodes>& tangent) const;
    void add_inertial_force(const Motions<Nodes>& motions,
                            const Vec3& gravity,
                            NodalVector<Nodes>& force) const;
    void add_inertial_tangent(const Motions<Nodes>& motions,
                              const Vec3& gravity,
                              const Linearizations<Nodes>& linearizations,
                              NodalMatrix<Nodes>& tangent) const;

    // The histories of a rod in its reference shape.
    void start(std::span<SectionHistory> histories) const;
    // Takes the trial motion as the last accepted step: Λ_n ← exp(θ) Λ_n, K_n ← K.
    void commit(const Motions<Nodes>& motions, std::span<SectionHistory> histories) const;

    double strain_energy(const Motions<Nodes>& motions, Histories histories) const;
    double kinetic_energy(const Motions<Nodes>& motions) const;
    double gravity_potential(const Motions<Nodes>& motions, const Vec3& gravity) const;
    Momentum momentum(const Motions<Nodes>& motions) const;

    // Strains and resultants at the force point nearest to the middle.
    SectionValues section_values(const Motions<Nodes>& motions, Histories histories) const;

  private:
    using Interpolation = Eigen::Matrix<double, 9, 6 * Nodes>;

    struct ForcePoint {
        NodeValues<Nodes> shape;  // N_I
        NodeValues<Nodes> slope;  // dN_I/ds
        double weight;            // in arc length
        Quat axes;                // section axes at t = 0
        ReferenceStrain reference;
    };

    // Strains (Γ, K) at one force point, material.
    Vec6 compute_strain(const Motions<Nodes>& motions, Histories histories, int point) const;
    static SimoFields interpolate(const ForcePoint& point, const Motions<Nodes>& motions);
    static Interpolation compute_interpolation(const ForcePoint& point);
    // Gradient of the strain energy with respect to all (r_I, θ_I).
    NodalVector<Nodes> compute_energy_gradient(const Motions<Nodes>& motions, Histories histories) const;
    NodalMatrix<Nodes> compute_energy_hessian(const Motions<Nodes>& motions, Histories histories) const;

    std::array<ForcePoint, Nodes - 1> points_;
    Mat6 stiffness_;
    RodInertia<Nodes> inertia_;
};

static_assert(Element<SimoElement<2>>);
extern template class SimoElement<2>;

}  // namespace gxrod
