#pragma once

#include "environment/running_integral.hpp"

namespace gxrod {

// JONSWAP's spectrum of a sea (K. Hasselmann et al., 1973), scaled so that its integral is Hs²/16; with γ = 1
// it is the spectrum of Pierson and Moskowitz. S(ω) = A ω⁻⁵ exp(−5/4 (ω_p/ω)⁴) γ^exp(−(ω − ω_p)²/(2σ²ω_p²)),
// σ = 0.07 up to ω_p, 0.09 beyond.
class JonswapSpectrum {
  public:
    JonswapSpectrum(double significant_height, double peak_period, double enhancement);

    double peak_frequency() const { return peak_; }
    double density(double frequency) const;      // S, height² time
    double share_below(double frequency) const;  // share of the variance, 0 to 1
    double find_frequency(
        double share) const;     // frequency with this share below it, more than 0 and less than 1
    double mean_period() const;  // T_m01 = 2π m₀/m₁, for all frequencies

  private:
    double energy_below(double x) const;

    double variance_, peak_, enhancement_;
    RunningIntegral enhanced_;  // the contribution of γ to ∫x⁻⁵exp(−5/4 x⁻⁴)dx, x = ω/ω_p
    double energy_;             // value of the whole integral
};

}  // namespace gxrod
