#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "model/surroundings.hpp"

// Trains of Airy waves that make up a sea.
namespace gxrod {

// The water of waves: its `depth`, or deep water without one.
struct WavePlace {
    std::optional<double> depth{};
    double gravity = 9.81;
};

struct IrregularSea {
    double significant_height = 0.0;  // Hs
    double peak_period = 0.0;         // Tp
    double enhancement = 3.3;         // γ
    int components = 200;
    std::uint64_t seed = 1;
    double direction = 0.0;             // θ₀, from x towards y
    std::optional<double> spreading{};  // s: directions as cos²ˢ((θ − θ₀)/2); without it all are θ₀
    double highest_frequency = 5.0;     // relative to the peak's: cutoff of the spectrum
};

// Makes components of equal energy, Hs²/16 together, so that the sea does not repeat itself. Each has a
// random frequency, phase and, with spreading, direction, in this order from one generator; the frequency
// comes from a share of the energy within the band.
std::vector<WaveTrain> make_irregular_sea(const IrregularSea& sea, const WavePlace& place);

// Elevations at one place, from still water, at equal time steps.
struct ElevationRecord {
    double start = 0.0;      // time of the first elevation
    double time_step = 0.0;  // more than 0
    std::vector<double> elevations;
    double x = 0.0, y = 0.0;        // place of the measurement
    double direction = 0.0;         // direction of the waves
    double lowest_frequency = 0.0;  // ω; frequencies outside of these limits are left out
    std::optional<double> highest_frequency{};
};

// Finds the time step of a table of times. Throws std::invalid_argument, with the place, if there are fewer
// than two or if steps differ from the mean by more than a thousandth of it.
double find_time_step(const std::vector<double>& times);

// Makes components that reproduce a record without its mean, again and again after its length.
std::vector<WaveTrain> make_recorded_sea(const ElevationRecord& record, const WavePlace& place);

// Measures of trains from their moments m_i = Σ ½a²ωⁱ.
struct SeaMeasures {
    double significant_height = 0.0;    // 4 √m₀
    double mean_period = 0.0;           // 2π m₀/m₁
    double zero_crossing_period = 0.0;  // 2π √(m₀/m₂)
    double steepness = 0.0;             // Hs/λ for the mean wave number by energy, k̄ = Σ ½a²k/m₀
};
SeaMeasures measure_sea(const std::vector<WaveTrain>& trains);

}  // namespace gxrod
