#pragma once

#include "elements/rod/interpolated_rod.hpp"

namespace gxrod {

// Simo & Vu-Quoc (1986): the element interpolates positions and the rotation vectors θ_I since the last
// accepted step. The map between nodal and local motions is δθ_I = T(θ_I)⁻¹ δφ_I, so that test functions are
// δφ(s) = T(θ(s)) Σ N_I T(θ_I)⁻¹ δφ_I (docs/theory/rods.md, (R12)).
template <int Nodes>
class SimoMap {
  public:
    // Sections remember their axes and curvature at the last accepted step.
    static constexpr int history_count = Nodes - 1;

    SimoMap(const Motions<Nodes>& motions, const std::array<Quat, Nodes>& triads);

    const LocalMotion<Nodes>& local() const { return local_; }
    LocalMotion<Nodes> compute_rates(const Motions<Nodes>& motions) const;
    // Computes the section axes of a point from its history.
    Quat turn_out(const Quat& axes) const { return axes; }
    // This corresponds to ObjectiveMap, but there is no frame.
    static Eigen::Matrix<double, 3, 6 * Nodes> compute_frame_spin() {
        return Eigen::Matrix<double, 3, 6 * Nodes>::Zero();
    }
    // Returns the largest relative rotation that the interpolation takes the short way round: none here.
    double largest_relative_rotation() const { return 0.0; }

    // Takes a generalised force of the local motion to forces and moments.
    void add_force(const NodalVector<Nodes>& local_force, NodalVector<Nodes>& force) const;
    // Adds the derivative of add_force's result, if the local force has this derivative by the local motion.
    void add_tangent(const NodalVector<Nodes>& local_force,
                     const NodalMatrix<Nodes>& local_tangent,
                     const Linearizations<Nodes>& linearizations,
                     NodalMatrix<Nodes>& tangent) const;
    // Adds the part of that derivative through the rates, if the local force has this derivative by them.
    void add_rate_tangent(const Motions<Nodes>& motions,
                          const NodalMatrix<Nodes>& local_tangent,
                          const Linearizations<Nodes>& linearizations,
                          NodalMatrix<Nodes>& tangent) const;

  private:
    NodalMatrix<Nodes> pull_rows(NodalMatrix<Nodes> rows) const;

    LocalMotion<Nodes> local_;
    std::array<Mat3, Nodes> inverse_tangents_;
};

extern template class SimoMap<2>;
extern template class SimoMap<3>;
extern template class SimoMap<4>;
extern template class SimoMap<5>;

}  // namespace gxrod
