#pragma once

#include "rotation/types.hpp"

namespace gxrod::rubin2007 {

struct MatrixMotion {
    Mat3 Lambda;
    Vec3 omega;
};

// Takes one step of the classical Runge-Kutta scheme on the nine entries of Λ and on ω, as Rubin (2007) does
// for comparison, (6.20): Λ̇ = [ω]× Λ, ω̇ = J⁻¹(M − ω × J ω) with J = Λ J̄ Λᵀ inverted as it stands, Λ never
// re-orthogonalised.
MatrixMotion step_matrix_rk4(const MatrixMotion& motion, double time, double time_step);

// Computes J ω with J = Λ J̄ Λᵀ.
Vec3 compute_momentum(const MatrixMotion& motion);

}  // namespace gxrod::rubin2007
