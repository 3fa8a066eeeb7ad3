#pragma once

namespace gxrod {

// Finds the damping τ, times the speed v of the approach, with which an impact by the force λ(g)(1 − τ ġ) is
// left at the speed e v, whatever λ: c − ln(1 + c) = −e c − ln(1 − e c), c = τ v (docs/theory/contact.md,
// (C31)). It is 0 for e = 1, and near 1/e for a small e > 0.
double find_damping_number(double restitution);

}  // namespace gxrod
