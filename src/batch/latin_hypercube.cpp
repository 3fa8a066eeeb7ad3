#include "batch/latin_hypercube.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>
#include <unsupported/Eigen/SpecialFunctions>

namespace gxrod {
namespace {

// The library's distributions differ between its makers; the engine and seed_seq do not.
class Generator {
  public:
    Generator(std::string_view key, std::uint64_t seed) {
        std::vector<std::uint32_t> words{static_cast<std::uint32_t>(seed),
                                         static_cast<std::uint32_t>(seed >> 32)};
        for (const char letter : key) words.push_back(static_cast<unsigned char>(letter));
        std::seed_seq sequence(words.begin(), words.end());
        engine_.seed(sequence);
    }

    // In (0, 1).
    double uniform() {
        constexpr double spacing = 0x1p-53;
        return (static_cast<double>(engine_() >> 11) + 0.5) * spacing;
    }

    // 0 … count − 1.
    std::size_t below(std::size_t count) {
        return std::min(static_cast<std::size_t>(uniform() * static_cast<double>(count)), count - 1);
    }

  private:
    std::mt19937_64 engine_;
};

double normal_probability(double value) { return 0.5 * std::erfc(-value / std::numbers::sqrt2); }

// Mean and deviation of the normal distribution behind a normal or lognormal one.
struct Normal {
    double mean;
    double deviation;
};

Normal normal_behind(const Spread& spread) {
    if (spread.kind == Spread::Kind::normal) return {spread.mean, spread.deviation};
    const double ratio = spread.deviation / spread.mean;
    const double variance = std::log1p(ratio * ratio);
    return {std::log(spread.mean) - 0.5 * variance, std::sqrt(variance)};
}

}  // namespace

std::vector<double> draw_probabilities(std::string_view key, std::uint64_t seed, long count) {
    Generator generator(key, seed);
    const auto size = static_cast<std::size_t>(count);
    std::vector<double> probabilities(size);
    for (std::size_t i = 0; i < size; ++i)
        probabilities[i] = (static_cast<double>(i) + generator.uniform()) / static_cast<double>(size);
    for (std::size_t i = size; i > 1; --i) std::swap(probabilities[i - 1], probabilities[generator.below(i)]);
    return probabilities;
}

double quantile(const Spread& spread, double probability) {
    if (spread.kind == Spread::Kind::uniform) return spread.from + probability * (spread.to - spread.from);
    const bool is_log = spread.kind == Spread::Kind::lognormal;
    const auto [mean, deviation] = normal_behind(spread);
    const auto probability_below = [&](double limit) {
        if (is_log && limit <= 0.0) return 0.0;
        return normal_probability(((is_log ? std::log(limit) : limit) - mean) / deviation);
    };
    const double lowest = probability_below(spread.from);
    const double highest = probability_below(spread.to);
    const double number = mean + deviation * Eigen::numext::ndtri(lowest + probability * (highest - lowest));
    return std::clamp(is_log ? std::exp(number) : number, spread.from, spread.to);
}

}  // namespace gxrod
