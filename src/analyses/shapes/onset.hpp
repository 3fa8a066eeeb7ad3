#pragma once

#include <functional>
#include <optional>

#include "state/records/sweep_record.hpp"

namespace gxrod {

// Finds the eigenvalues with Im λ ≥ 0 at a value of the parameter; none if there is no equilibrium.
using FindLambdas = std::function<std::vector<std::complex<double>>(double value)>;

// Returns the largest Re λ.
double find_growth(const std::vector<std::complex<double>>& lambdas);
// Whether one of the eigenvalues grows by more than round-off.
bool is_growing(const std::vector<std::complex<double>>& lambdas);

// Finds where growth begins between a stable and an unstable value: the zero of the largest Re λ. Without
// damping, Re λ vanishes up to that point; then the zero of a function that is smooth there: λ², or the
// discriminant (λ₁² − λ₂²)² of two eigenvalues that merge.
std::optional<Onset> find_onset(const FindLambdas& find_lambdas, double stable, double unstable);

}  // namespace gxrod
