#pragma once

#include <vector>

#include "elements/element.hpp"
#include "elements/rod/rod_section.hpp"
#include "elements/rod/section_strain.hpp"
#include "numerics/gauss_legendre.hpp"
#include "numerics/lagrange.hpp"

namespace gxrod {

// Nodal unknowns of a rod with interpolated positions and rotation vectors, r(s) = Σ N_I r_I and θ(s) = Σ N_I
// θ_I: a column per node. The caller chooses the attitude from which rotation vectors are measured.
template <int Nodes>
struct LocalMotion {
    Eigen::Matrix<double, 3, Nodes> r;
    Eigen::Matrix<double, 3, Nodes> theta;
};

// Elastic energy and Kelvin-Voigt damping of a rod as a function of such unknowns. Forces and matrices are
// stacked per node: three of r_I, three of θ_I. Integrated with Nodes − 1 Gauss points, which does not lock.
template <int Nodes>
class InterpolatedRod {
  public:
    static constexpr int point_count = Nodes - 1;
    // The attitude of each point's section from which θ is measured.
    using PointHistories = std::array<SectionHistory, point_count>;

    using PointSections = std::array<SharedRodSection, point_count>;
    using PointStrains = std::array<Vec6, point_count>;

    // Takes the shape at t = 0. Its interpolation has these strains (Γ, K), which are zero if it is free of
    // stress.
    InterpolatedRod(const LocalMotion<Nodes>& start,
                    const PointHistories& histories,
                    const PointSections& sections,
                    const PointStrains& strains);

    bool is_damped() const { return section(0).kelvin_voigt > 0.0; }
    const RodSection& section(int point) const { return *sections_[point]; }
    // ds/dξ and the strains of the reference shape at a point of the quadrature.
    struct ReferencePoint {
        double jacobian;
        ReferenceStrain strain;
    };
    const ReferencePoint& reference(int point) const { return points_[point]; }

    // Computes the resultants from the strains of a point relative to the reference, by its section's law and
    // the actions within the section; no other function does. The dissipated energy, and the memory of the
    // law in `after`, count from the last accepted step.
    SectionResponse respond(int point,
                            const Vec6& strain,
                            Histories histories,
                            std::span<double> after = {}) const;
    // Adds the drives of the rod's sections, and the strains on which they do work.
    void add_driven_points(const LocalMotion<Nodes>& motion,
                           Histories histories,
                           std::vector<DrivenPoint>& points) const;
    // Whether resultants are the stiffness × the strains, at every point.
    bool is_linear(Histories histories) const { return !has_law() && histories.drives.empty(); }
    // Whether sections have laws: at all points, or at none.
    bool has_law() const { return section(0).law != nullptr; }
    // The number of values that the laws of all points remember, point by point.
    int memory_count() const { return count_memory_before(point_count); }

    double strain_energy(const LocalMotion<Nodes>& motion, Histories histories) const;
    // Computes the dissipation of laws since the last accepted step.
    double dissipated_energy(const LocalMotion<Nodes>& motion, Histories histories) const;
    // Computes ∂W/∂(r_I, θ_I).
    NodalVector<Nodes> compute_gradient(const LocalMotion<Nodes>& motion, Histories histories) const;
    // The gradient with ∂²W/∂(r_I, θ_I)², symmetric where D is.
    struct Derivatives {
        NodalVector<Nodes> gradient;
        NodalMatrix<Nodes> hessian;
    };
    Derivatives compute_derivatives(const LocalMotion<Nodes>& motion, Histories histories) const;

    // Compute, for resultants S of the points that need not follow from the strains, Σ Eᵀ S in place of the
    // gradient, and Σ (Eᵀ C E + G(S)) in place of the hessian (docs/theory/rods.md, (R34)).
    NodalVector<Nodes> compute_force_of(const LocalMotion<Nodes>& motion,
                                        Histories histories,
                                        Resultants resultants) const;
    NodalMatrix<Nodes> compute_mixed_hessian(const LocalMotion<Nodes>& motion,
                                             Histories histories,
                                             Resultants resultants) const;
    // Computes S + D E_u δu: the resultants after an increment δu of the motion, to first order; for a linear
    // section C (E + E_u δu).
    void advance_resultants(const LocalMotion<Nodes>& motion,
                            const LocalMotion<Nodes>& increment,
                            Histories histories,
                            std::span<Vec6> resultants) const;
    // Does the same at one point, from its strain and the change of the strain.
    Vec6 advance_resultants(int point, const Vec6& strain, const Vec6& change, Histories histories) const;

    // Computes the generalised force of the resultants τ C Ė (Kelvin & Voigt), Ė the strain rates at these
    // `rates`.
    NodalVector<Nodes> compute_damping_force(const LocalMotion<Nodes>& motion,
                                             const LocalMotion<Nodes>& rates,
                                             Histories histories) const;
    // The derivatives of this force by the motion and by the rates.
    struct DampingTangents {
        NodalMatrix<Nodes> by_motion, by_rates;
    };
    DampingTangents compute_damping_tangents(const LocalMotion<Nodes>& motion,
                                             const LocalMotion<Nodes>& rates,
                                             Histories histories) const;
    // Computes ∫ τ ΔE · C ΔE ds for the change ΔE of the strains from one motion to another, both with the
    // same histories: divided by the duration, the dissipation of Kelvin-Voigt damping at the mean strain
    // rates.
    double damping_action(const LocalMotion<Nodes>& previous,
                          const LocalMotion<Nodes>& trial,
                          Histories histories) const;
    // Does the same for a rod with one force point, from the change of its strain.
    double damping_action(const Vec6& change) const;

    // Compute ∫ δE (D δE) ds, component by component, for the first-order strain increment of an increment of
    // the motion; and the same for a rod with one force point, from that change and D.
    Vec6 compute_strain_work(const LocalMotion<Nodes>& motion,
                             const LocalMotion<Nodes>& increment,
                             Histories histories) const;
    Vec6 compute_strain_work(const Vec6& change, const Mat6& stiffness) const;

    // Sets Λ and the total curvature of each point, for the next step.
    void advance(const LocalMotion<Nodes>& motion, std::span<SectionHistory> axes) const;
    // Sets the memory of laws for the next step. `memory` can be the one in the histories.
    void advance_memory(const LocalMotion<Nodes>& motion,
                        Histories histories,
                        std::span<double> memory) const;

    // Strains and resultants τ C Ė + C E.
    struct SectionState {
        Vec6 strain, resultants;
    };
    // Computes the state in the middle: of the point there, or the mean of its two neighbours.
    SectionState compute_middle_state(const LocalMotion<Nodes>& motion,
                                      const LocalMotion<Nodes>& rates,
                                      Histories histories) const;
    // Computes the state at ξ, with the section's stiffness there, by the polynomial through the points and
    // the given resultants of both ends, first the start's.
    SectionState interpolate_state(const LocalMotion<Nodes>& motion,
                                   const LocalMotion<Nodes>& rates,
                                   Histories histories,
                                   const std::array<Vec6, 2>& end_resultants,
                                   const Mat6& stiffness_there,
                                   double xi) const;

  private:
    struct ForcePoint {
        NodeValues<Nodes> shape;  // N_I
        NodeValues<Nodes> slope;  // dN_I/ds
        double weight;            // in arc length
        const ReferenceStrain& reference;
    };

    ForcePoint force_point(int point) const;
    static SectionFields interpolate(const ForcePoint& point, const LocalMotion<Nodes>& motion);
    SectionState compute_section_state(int point,
                                       const LocalMotion<Nodes>& motion,
                                       const LocalMotion<Nodes>& rates,
                                       Histories histories) const;
    static void add_force(const ForcePoint& point, const Vec9& density, NodalVector<Nodes>& force);
    static void add_matrix(const ForcePoint& point, const Mat9& density, NodalMatrix<Nodes>& matrix);
    int count_memory_before(int point) const {
        int count = 0;
        for (int p = 0; p < point; ++p) count += section(p).memory_size();
        return count;
    }
    const Mat6& stiffness(int point) const { return section(point).stiffness; }
    // Whether a section is linear: stiffness × strains, to the last bit.
    Vec6 compute_resultants(int point, const Vec6& strain, Histories histories) const;
    // Returns the strains including the reference strains: (Λᵀ r′, K).
    Vec6 compute_total_strain(int point, const Vec6& strain) const;
    // Returns D at the strains of these fields.
    Mat6 compute_stiffness(int point, const SectionFields& fields, Histories histories) const;
    Vec6 compute_strain_rates(const ForcePoint& point,
                              const LocalMotion<Nodes>& motion,
                              const LocalMotion<Nodes>& rates,
                              const SectionHistory& history) const;

    std::array<ReferencePoint, point_count> points_;
    PointSections sections_;
};

extern template class InterpolatedRod<2>;
extern template class InterpolatedRod<3>;
extern template class InterpolatedRod<4>;
extern template class InterpolatedRod<5>;

}  // namespace gxrod
