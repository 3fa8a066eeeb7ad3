#pragma once

#include "elements/rod/interpolated_rod.hpp"

namespace gxrod {

// Crisfield & Jelenić (1999): the element interpolates rotations relative to its triad R, so that strains
// depend neither on a rigid rotation nor on the path. R is the section triad of the middle node or, for an
// even number of nodes, half-way between the two middle ones. Section triads are Λ_I triad_I = R exp(ψ_I),
// and R exp(Σ N_I ψ_I) between the nodes; positions are relative to R too (docs/theory/rods.md, (R13)–(R22)).
//
// All calculation is in the axes of R. Its spin is δφ_R = A_a δφ_a + A_b δφ_b with the two middle nodes a, b
// (one: A = I), and δρ_I = δr_I + ρ_I × δφ_R, δψ_I = T(ψ_I)⁻¹ (δφ_I − δφ_R).
template <int Nodes>
class ObjectiveMap {
  public:
    static constexpr int history_count = 0;

    ObjectiveMap(const Motions<Nodes>& motions, const std::array<Quat, Nodes>& triads);

    const LocalMotion<Nodes>& local() const { return local_; }
    LocalMotion<Nodes> compute_rates(const Motions<Nodes>& motions) const;
    Quat turn_out(const Quat& axes) const { return frame_ * axes; }
    // Computes the spin of R by (δr, δφ) of the nodes, spatial.
    Eigen::Matrix<double, 3, 6 * Nodes> compute_frame_spin() const;
    // Computes section axes between the nodes, and their angular velocity; `shape` are the shape functions
    // there.
    Quat interpolate_axes(const NodeValues<Nodes>& shape) const;
    Vec3 interpolate_spin(const Motions<Nodes>& motions, const NodeValues<Nodes>& shape) const;
    // Returns the largest rotation between two nodes, or a node and R, that the logarithm measures, at most
    // π.
    double largest_relative_rotation() const { return largest_relative_rotation_; }

    // These do the same as in SimoMap.
    void add_force(const NodalVector<Nodes>& local_force, NodalVector<Nodes>& force) const;
    void add_tangent(const NodalVector<Nodes>& local_force,
                     const NodalMatrix<Nodes>& local_tangent,
                     const Linearizations<Nodes>& linearizations,
                     NodalMatrix<Nodes>& tangent) const;
    void add_rate_tangent(const Motions<Nodes>& motions,
                          const NodalMatrix<Nodes>& local_tangent,
                          const Linearizations<Nodes>& linearizations,
                          NodalMatrix<Nodes>& tangent) const;

  private:
    static constexpr bool has_pair = Nodes % 2 == 0;
    static constexpr int a = (Nodes - 1) / 2;
    static constexpr int b = Nodes / 2;  // a for an odd number of nodes

    using FrameRows = Eigen::Matrix<double, 3, 6 * Nodes>;
    using FrameColumns = Eigen::Matrix<double, 6 * Nodes, 3>;
    using Columns3 = Eigen::Matrix<double, 3, Nodes>;

    void find_frame(const std::array<Quat, Nodes>& axes);
    // Turns forces conjugate to ψ into moments, and returns the moment of all on R.
    FrameRows pull_rows(NodalMatrix<Nodes>& rows) const;
    void add_frame_rows(const FrameRows& on_frame, NodalMatrix<Nodes>& rows) const;
    // Turns columns by (ρ, ψ) and by the spin of R into columns by (δr, δφ).
    void push_columns(FrameColumns by_frame, NodalMatrix<Nodes>& matrix) const;
    void add_turned_out(const NodalMatrix<Nodes>& matrix,
                        const Linearizations<Nodes>& linearizations,
                        NodalMatrix<Nodes>& tangent) const;

    // Forces in the axes of R: n_I on positions, the moments m_I = T(ψ_I)⁻ᵀ × the force conjugate to ψ_I, and
    // the moment M on R.
    struct FrameForces {
        Columns3 n, m;
        Vec3 M;
        NodalVector<Nodes> stacked;  // on the nodes, including the share of R
    };
    FrameForces compute_frame_forces(const NodalVector<Nodes>& local_force) const;

    // Nodal rates in the axes of R, positions from node a, and the spin of R.
    struct FrameRates {
        Columns3 v, omega;
        Vec3 omega_R;
    };
    FrameRates compute_frame_rates(const Motions<Nodes>& motions) const;

    // Derivatives of the rates of (ρ, ψ) by (ρ, ψ) and by the spin of R, at fixed nodal rates.
    struct RateGradients {
        NodalMatrix<Nodes> by_motion;
        FrameColumns by_frame;
    };
    RateGradients compute_rate_gradients(const FrameRates& rates) const;

    Quat frame_;
    Mat3 frame_matrix_;
    LocalMotion<Nodes> local_;
    std::array<Mat3, Nodes> inverse_tangents_;
    Mat3 share_of_a_, share_of_b_;
    Mat3 tau_gradient_;  // ∂τ/∂(ψ_b − ψ_a), τ the vector of A_a = ½(I + [τ]×), A_b = ½(I − [τ]×)
    double largest_relative_rotation_ = 0.0;
};

extern template class ObjectiveMap<2>;
extern template class ObjectiveMap<3>;
extern template class ObjectiveMap<4>;
extern template class ObjectiveMap<5>;

}  // namespace gxrod
