#pragma once

#include "rotation/types.hpp"

// Matrices of a section about other points and in other axes.
namespace gxrod {

// A frame in a section: a point, in the section's axes, and the section's axes turned about x, right-handed:
// from y towards z.
struct SectionFrame {
    double y = 0.0, z = 0.0;
    double turn = 0.0;

    bool is_trivial() const { return y == 0.0 && z == 0.0 && turn == 0.0; }
};

// Returns T, which takes strains (Γ, K) at the section's node to those at the frame's point, in its axes.
Mat6 compute_strain_map(const SectionFrame& frame);

// Moves a stiffness or an inertia, order x y z rx ry rz, given about the point of a frame and in its axes, to
// the section's node and axes. With R from the frame's axes to the section's and d its point,
//     Γ′ = Rᵀ(Γ + K × d), K′ = Rᵀ K, and the same of v and ω: (Γ′, K′) = T (Γ, K), C = Tᵀ C′ T, M = Tᵀ M′ T.
Mat6 move_from(const SectionFrame& frame, const Mat6& matrix);
// Applies the inverse.
Mat6 move_to(const SectionFrame& frame, const Mat6& matrix);

}  // namespace gxrod
