#include "environment/spectrum.hpp"

#include <cmath>
#include <numbers>

namespace gxrod {

namespace {

constexpr double below_peak = 0.07, above_peak = 0.09;
// Nine σ: e^{−81/2} is 3e-18.
constexpr double reach = 9.0;

// x⁻⁵ exp(−5/4 x⁻⁴), whose integral up to x is exp(−5/4 x⁻⁴)/5.
double plain_density(double x) { return std::pow(x, -5.0) * std::exp(-1.25 * std::pow(x, -4.0)); }
double plain_energy(double x) { return 0.2 * std::exp(-1.25 * std::pow(x, -4.0)); }

// γ^exp(…) − 1.
double enhancement_at(double x, double enhancement) {
    const double distance = (x - 1.0) / (x <= 1.0 ? below_peak : above_peak);
    return std::expm1(std::log(enhancement) * std::exp(-0.5 * distance * distance));
}

std::vector<double> list_edges() {
    constexpr int pieces = 12;
    std::vector<double> edges;
    for (int i = 0; i < pieces; ++i) edges.push_back(1.0 - reach * below_peak * (pieces - i) / pieces);
    for (int i = 0; i <= pieces; ++i) edges.push_back(1.0 + reach * above_peak * i / pieces);
    return edges;
}

}  // namespace

JonswapSpectrum::JonswapSpectrum(double significant_height, double peak_period, double enhancement)
    : variance_(significant_height * significant_height / 16.0),
      peak_(2.0 * std::numbers::pi / peak_period),
      enhancement_(enhancement),
      enhanced_([enhancement](double x) { return plain_density(x) * enhancement_at(x, enhancement); },
                list_edges()),
      energy_(0.2 + enhanced_.whole()) {}

double JonswapSpectrum::density(double frequency) const {
    if (!(frequency > 0.0)) return 0.0;
    const double x = frequency / peak_;
    return variance_ / (energy_ * peak_) * plain_density(x) * (1.0 + enhancement_at(x, enhancement_));
}

double JonswapSpectrum::energy_below(double x) const { return plain_energy(x) + enhanced_.up_to(x); }

double JonswapSpectrum::share_below(double frequency) const {
    return frequency > 0.0 ? energy_below(frequency / peak_) / energy_ : 0.0;
}

double JonswapSpectrum::find_frequency(double share) const {
    double low = 0.5, high = 2.0;
    while (share_below(low * peak_) > share) low *= 0.5;
    while (share_below(high * peak_) < share) high *= 2.0;
    return find_value([&](double frequency) { return share_below(frequency); },
                      [&](double frequency) { return density(frequency) / variance_; },
                      share,
                      {low * peak_, high * peak_});
}

double JonswapSpectrum::mean_period() const {
    const double enhancement = enhancement_;
    const RunningIntegral enhanced(
        [enhancement](double x) { return x * plain_density(x) * enhancement_at(x, enhancement); },
        list_edges());
    // ∫x⁻⁴ exp(−5/4 x⁻⁴)dx = Γ(3/4)/(4 (5/4)^¾).
    const double first = 0.25 * std::tgamma(0.75) * std::pow(1.25, -0.75) + enhanced.whole();
    return 2.0 * std::numbers::pi * energy_ / (first * peak_);
}

}  // namespace gxrod
