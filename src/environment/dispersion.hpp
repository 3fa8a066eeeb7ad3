#pragma once

#include <optional>

namespace gxrod {

// Finds the wave number k > 0 of Airy waves with the frequency ω > 0 over a depth: ω² = g k tanh(k d), to
// round-off; without a depth, for deep water.
double find_wave_number(double frequency, std::optional<double> depth, double gravity);

}  // namespace gxrod
