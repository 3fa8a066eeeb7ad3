#include "environment/sea.hpp"

#include <fmt/format.h>

#include <cmath>
#include <complex>
#include <numbers>
#include <stdexcept>
#include <unsupported/Eigen/FFT>

#include "environment/dispersion.hpp"
#include "environment/spectrum.hpp"
#include "environment/splitmix64.hpp"

namespace gxrod {

namespace {

using std::numbers::pi;

// Angles from the main direction with a density as cos²ˢ(angle/2).
class Spreading {
  public:
    explicit Spreading(double exponent) : exponent_(exponent), integral_(make_integral(exponent)) {}

    double find_angle(double share) const {
        const double whole = integral_.whole();
        return find_value([&](double angle) { return integral_.up_to(angle) / whole; },
                          [&](double angle) { return density(exponent_, angle) / whole; },
                          share,
                          {-pi, pi});
    }

  private:
    static double density(double exponent, double angle) {
        return std::pow(std::cos(0.5 * angle), 2.0 * exponent);
    }
    static RunningIntegral make_integral(double exponent) {
        constexpr int pieces = 64;
        std::vector<double> edges;
        for (int i = 0; i <= pieces; ++i) edges.push_back(pi * (2.0 * i / pieces - 1.0));
        return {[exponent](double angle) { return density(exponent, angle); }, edges};
    }

    double exponent_;
    RunningIntegral integral_;
};

}  // namespace

std::vector<WaveTrain> make_irregular_sea(const IrregularSea& sea, const WavePlace& place) {
    const JonswapSpectrum spectrum(sea.significant_height, sea.peak_period, sea.enhancement);
    const double covered = spectrum.share_below(sea.highest_frequency * spectrum.peak_frequency());
    std::optional<Spreading> spreading;
    if (sea.spreading) spreading.emplace(*sea.spreading);
    Splitmix64 random(sea.seed);
    std::vector<WaveTrain> trains(static_cast<std::size_t>(sea.components));
    for (std::size_t i = 0; i < trains.size(); ++i) {
        WaveTrain& train = trains[i];
        // Hs²/16 = Σ ½a².
        train.amplitude = sea.significant_height / std::sqrt(8.0 * sea.components);
        const double share = (static_cast<double>(i) + random.next_fraction()) / sea.components;
        train.frequency = spectrum.find_frequency(std::max(covered * share, 1e-300));
        train.number = find_wave_number(train.frequency, place.depth, place.gravity);
        train.phase = 2.0 * pi * random.next_fraction();
        train.direction = sea.direction;
        if (spreading) train.direction += spreading->find_angle(random.next_fraction());
    }
    return trains;
}

double find_time_step(const std::vector<double>& times) {
    if (times.size() < 2) throw std::invalid_argument("a record needs two times or more");
    const double step = (times.back() - times.front()) / static_cast<double>(times.size() - 1);
    if (!(step > 0.0)) throw std::invalid_argument("times of a record must increase");
    for (std::size_t i = 1; i < times.size(); ++i) {
        const double own = times[i] - times[i - 1];
        if (!(std::abs(own - step) <= 1e-3 * step)) {
            throw std::invalid_argument(fmt::format(
                "times of a record must have equal steps: from {} to {} it is {}, on the average {}",
                times[i - 1],
                times[i],
                own,
                step));
        }
    }
    return step;
}

std::vector<WaveTrain> make_recorded_sea(const ElevationRecord& record, const WavePlace& place) {
    Eigen::FFT<double> transform;
    std::vector<std::complex<double>> spectrum;
    transform.fwd(spectrum, record.elevations);
    const std::size_t count = record.elevations.size();
    const double first = 2.0 * pi / (static_cast<double>(count) * record.time_step);
    const double along = record.x * std::cos(record.direction) + record.y * std::sin(record.direction);
    std::vector<WaveTrain> trains;
    for (std::size_t i = 1; 2 * i <= count; ++i) {
        WaveTrain train;
        train.frequency = first * static_cast<double>(i);
        if (train.frequency < record.lowest_frequency) continue;
        if (record.highest_frequency && train.frequency > *record.highest_frequency) break;
        // Of an even number of elevations the last component is its own partner.
        const double share = 2 * i == count ? 1.0 : 2.0;
        train.amplitude = share * std::abs(spectrum[i]) / static_cast<double>(count);
        if (train.amplitude == 0.0) continue;
        train.number = find_wave_number(train.frequency, place.depth, place.gravity);
        train.direction = record.direction;
        // a cos(ω(t − start) + arg) = a cos(k s − ωt + φ) at the place.
        train.phase = train.frequency * record.start - std::arg(spectrum[i]) - train.number * along;
        trains.push_back(train);
    }
    return trains;
}

SeaMeasures measure_sea(const std::vector<WaveTrain>& trains) {
    double zeroth = 0.0, first = 0.0, second = 0.0, numbers = 0.0;
    for (const WaveTrain& train : trains) {
        const double energy = 0.5 * train.amplitude * train.amplitude;
        zeroth += energy;
        first += energy * train.frequency;
        second += energy * train.frequency * train.frequency;
        numbers += energy * train.number;
    }
    if (zeroth == 0.0) return {};
    const double height = 4.0 * std::sqrt(zeroth);
    return {height,
            2.0 * pi * zeroth / first,
            2.0 * pi * std::sqrt(zeroth / second),
            height * numbers / (2.0 * pi * zeroth)};
}

}  // namespace gxrod
