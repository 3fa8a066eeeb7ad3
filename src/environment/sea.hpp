#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "model/surroundings.hpp"

// Trains of Airy waves that make a sea.
namespace gxrod {

// Where waves travel: `depth` of the water, of deep water without one.
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
    double highest_frequency = 5.0;     // of the peak's: where the spectrum is cut off
};

// Components of one energy, Hs²/16 together, so that the sea does not repeat itself. Each has a frequency, a
// phase and, where these spread, a direction by chance, in this order of one generator: the frequency by its
// share of the energy within the band.
std::vector<WaveTrain> make_irregular_sea(const IrregularSea& sea, const WavePlace& place);

// Elevations of one place, from still water, at equal steps of time.
struct ElevationRecord {
    double start = 0.0;      // time of the first
    double time_step = 0.0;  // more than 0
    std::vector<double> elevations;
    double x = 0.0, y = 0.0;        // where they were measured
    double direction = 0.0;         // where the waves go
    double lowest_frequency = 0.0;  // ω; those beyond are left out
    std::optional<double> highest_frequency{};
};

// The time step of a table of times; throws std::invalid_argument if they are fewer than two or if steps
// differ from the mean by more than a thousandth of it, saying where.
double find_time_step(const std::vector<double>& times);

// The components of a record, which they reproduce, again and again after its length, but for its mean.
std::vector<WaveTrain> make_recorded_sea(const ElevationRecord& record, const WavePlace& place);

// Moments of what trains have together, m_i = Σ ½a²ωⁱ.
struct SeaMeasures {
    double significant_height = 0.0;    // 4 √m₀
    double mean_period = 0.0;           // 2π m₀/m₁
    double zero_crossing_period = 0.0;  // 2π √(m₀/m₂)
    double steepness = 0.0;             // Hs/λ of the mean wave number by energy, k̄ = Σ ½a²k/m₀
};
SeaMeasures measure_sea(const std::vector<WaveTrain>& trains);

}  // namespace gxrod
