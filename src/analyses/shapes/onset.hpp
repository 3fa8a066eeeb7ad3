#pragma once

#include <functional>
#include <optional>

#include "state/records/sweep_record.hpp"

namespace gxrod {

// The eigenvalues with Im λ ≥ 0 at a value of the parameter; none if there is no equilibrium.
using FindLambdas = std::function<std::vector<std::complex<double>>(double value)>;

// The largest Re λ.
double find_growth(const std::vector<std::complex<double>>& lambdas);
// Whether one of them grows by more than round-off.
bool is_growing(const std::vector<std::complex<double>>& lambdas);

// Where between a value at which nothing grows and one at which something does it begins to: by the zero of
// the largest Re λ; undamped, where Re λ vanishes up to there, by that of what is smooth at such a point, λ²
// or the discriminant (λ₁² − λ₂²)² of two that merge.
std::optional<Onset> find_onset(const FindLambdas& find_lambdas, double stable, double unstable);

}  // namespace gxrod
